<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>nazori::ui::HomePage</name>
    <message numerus="yes">
        <source>Done for now. %n characters come once more, the first at %1.</source>
        <translation>
            <numerusform>Done for now. %n character comes once more, at %1.</numerusform>
            <numerusform>Done for now. %n characters come once more, the first at %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Done for today: your limit is reached. %n reviews wait for tomorrow.</source>
        <translation>
            <numerusform>Done for today: your limit is reached. %n review waits for tomorrow.</numerusform>
            <numerusform>Done for today: your limit is reached. %n reviews wait for tomorrow.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Done for today. Tomorrow %n reviews are due.</source>
        <translation>
            <numerusform>Done for today. Tomorrow %n review is due.</numerusform>
            <numerusform>Done for today. Tomorrow %n reviews are due.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n reviews have piled up. No hurry: today %1, what is best known first, so that most is kept.</source>
        <translation>
            <numerusform>%n review has been waiting. No hurry: today %1.</numerusform>
            <numerusform>%n reviews have piled up. No hurry: today %1, what is best known first, so that most is kept.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Catching up takes %n days; the last is %1. Until then nothing new is added.</source>
        <translation>
            <numerusform>Catching up takes %n day (%1). Until then nothing new is added.</numerusform>
            <numerusform>Catching up takes %n days; the last is %1. Until then nothing new is added.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more reviews wait for another day: that is your limit.</source>
        <translation>
            <numerusform>%n more review waits for another day: that is your limit.</numerusform>
            <numerusform>%n more reviews wait for another day: that is your limit.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>minutes, about</source>
        <translation>
            <numerusform>minute, about</numerusform>
            <numerusform>minutes, about</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters are forgotten often and set apart: %1</source>
        <translation>
            <numerusform>%n character is forgotten often and set apart: %1</numerusform>
            <numerusform>%n characters are forgotten often and set apart: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Done: %n written from memory.</source>
        <translation>
            <numerusform>Done: %n written from memory.</numerusform>
            <numerusform>Done: %n written from memory.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Start: %n characters, %1</source>
        <translation>
            <numerusform>Start: %n character, %1</numerusform>
            <numerusform>Start: %n characters, %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>days in a row</source>
        <translation>
            <numerusform>day in a row</numerusform>
            <numerusform>days in a row</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>days in a row; this week&apos;s day off is used</source>
        <translation>
            <numerusform>day in a row; this week&apos;s day off is used</numerusform>
            <numerusform>days in a row; this week&apos;s day off is used</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>days in a row; one day off a week is forgiven</source>
        <translation>
            <numerusform>day in a row; one day off a week is forgiven</numerusform>
            <numerusform>days in a row; one day off a week is forgiven</numerusform>
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
    <name>nazori::ui::SessionBar</name>
    <message numerus="yes">
        <source>a character of %n strokes</source>
        <translation>
            <numerusform>a character of %n stroke</numerusform>
            <numerusform>a character of %n strokes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::SessionPanel</name>
    <message numerus="yes">
        <source>Written from memory: %n times</source>
        <translation>
            <numerusform>Written from memory: once</numerusform>
            <numerusform>Written from memory: %n times</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Forgotten: %n times</source>
        <translation>
            <numerusform>Forgotten: once</numerusform>
            <numerusform>Forgotten: %n times</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Stroke %1 went wrong %n times.</source>
        <translation>
            <numerusform>Stroke %1 went wrong once.</numerusform>
            <numerusform>Stroke %1 went wrong %n times.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n strokes shown</source>
        <translation>
            <numerusform>%n stroke shown</numerusform>
            <numerusform>%n strokes shown</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hints</source>
        <translation>
            <numerusform>%n hint</numerusform>
            <numerusform>%n hints</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n misses</source>
        <translation>
            <numerusform>%n miss</numerusform>
            <numerusform>%n misses</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::StageWords</name>
    <message numerus="yes">
        <source>All %n strokes. Space plays them again; F6 goes on to tracing.</source>
        <translation>
            <numerusform>The one stroke. Space plays it again; F6 goes on to tracing.</numerusform>
            <numerusform>All %n strokes. Space plays them again; F6 goes on to tracing.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>All %n strokes are written. Delete clears the tablet.</source>
        <translation>
            <numerusform>The one stroke is written. Delete clears the tablet.</numerusform>
            <numerusform>All %n strokes are written. Delete clears the tablet.</numerusform>
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
    <message numerus="yes">
        <source>Write the character of %n strokes.</source>
        <translation>
            <numerusform>Write the character of %n stroke.</numerusform>
            <numerusform>Write the character of %n strokes.</numerusform>
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
    <name>nazori::ui::StudySettingsDialog</name>
    <message numerus="yes">
        <source>%n characters are postponed.</source>
        <translation>
            <numerusform>%n character is postponed.</numerusform>
            <numerusform>%n characters are postponed.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters are paused.</source>
        <translation>
            <numerusform>%n character is paused.</numerusform>
            <numerusform>%n characters are paused.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters come again.</source>
        <translation>
            <numerusform>%n character comes again.</numerusform>
            <numerusform>%n characters come again.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters are new again.</source>
        <translation>
            <numerusform>%n character is new again.</numerusform>
            <numerusform>%n characters are new again.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>With %1 new a day about %2 reviews and %n minutes a day; after a year about %3 characters known. Higher retention means more reviews.</source>
        <translation>
            <numerusform>With %1 new a day about %2 reviews and %n minute a day; after a year about %3 characters known. Higher retention means more reviews.</numerusform>
            <numerusform>With %1 new a day about %2 reviews and %n minutes a day; after a year about %3 characters known. Higher retention means more reviews.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln characters are chosen, %1 of them met already.</source>
        <translation>
            <numerusform>%Ln character is chosen, %1 met already.</numerusform>
            <numerusform>%Ln characters are chosen, %1 of them met already.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::StudyWords</name>
    <message numerus="yes">
        <source>in %n minutes</source>
        <translation>
            <numerusform>in %n minute</numerusform>
            <numerusform>in %n minutes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>in %n days</source>
        <translation>
            <numerusform>in %n day</numerusform>
            <numerusform>in %n days</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>in %n months</source>
        <translation>
            <numerusform>in %n month</numerusform>
            <numerusform>in %n months</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>about %n minutes</source>
        <translation>
            <numerusform>about %n minute</numerusform>
            <numerusform>about %n minutes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::plot_words</name>
    <message numerus="yes">
        <source>%n pieces</source>
        <translation>
            <numerusform>%n piece</numerusform>
            <numerusform>%n pieces</numerusform>
        </translation>
    </message>
</context>
</TS>
