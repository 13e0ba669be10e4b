<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>nazori::ui::FunctionsWorkplace</name>
    <message numerus="yes">
        <source>%n pieces</source>
        <translation>
            <numerusform>%n piece</numerusform>
            <numerusform>%n pieces</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::InformationPanel</name>
    <message numerus="yes">
        <source>%n strokes</source>
        <translation>
            <numerusform>%n stroke</numerusform>
            <numerusform>%n strokes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::LibraryPanel</name>
    <message numerus="yes">
        <source>%n found</source>
        <translation>
            <numerusform>%n found</numerusform>
            <numerusform>%n found</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters</source>
        <translation>
            <numerusform>%n character</numerusform>
            <numerusform>%n characters</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::MemoryStage</name>
    <message numerus="yes">
        <source>Write the character of %n strokes.</source>
        <translation>
            <numerusform>Write the character of %n stroke.</numerusform>
            <numerusform>Write the character of %n strokes.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n strokes are written. Enter judges them.</source>
        <translation>
            <numerusform>%n stroke is written. Enter judges it.</numerusform>
            <numerusform>%n strokes are written. Enter judges them.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Stroke %1 is right. %n to go.</source>
        <translation>
            <numerusform>Stroke %1 is right. %n to go.</numerusform>
            <numerusform>Stroke %1 is right. %n to go.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Taken back. %n strokes are written.</source>
        <translation>
            <numerusform>Taken back. %n stroke is written.</numerusform>
            <numerusform>Taken back. %n strokes are written.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::StrokeCounter</name>
    <message numerus="yes">
        <source>all %n strokes</source>
        <translation>
            <numerusform>one stroke</numerusform>
            <numerusform>all %n strokes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::StrokeTeller</name>
    <message numerus="yes">
        <source>All %n strokes are written. Delete clears the tablet.</source>
        <translation>
            <numerusform>The one stroke is written. Delete clears the tablet.</numerusform>
            <numerusform>All %n strokes are written. Delete clears the tablet.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::WatchStage</name>
    <message numerus="yes">
        <source>All %n strokes. Space plays them again; F6 goes on to tracing.</source>
        <translation>
            <numerusform>The one stroke. Space plays it again; F6 goes on to tracing.</numerusform>
            <numerusform>All %n strokes. Space plays them again; F6 goes on to tracing.</numerusform>
        </translation>
    </message>
</context>
</TS>
