<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>nazori::ui::BrushPage</name>
    <message numerus="yes">
        <source>Hold the stylus loosely: it leads your hand through %n strokes. V: stop.</source>
        <translation>
            <numerusform>Hold the stylus loosely: it leads your hand through %n stroke. V: stop.</numerusform>
            <numerusform>Hold the stylus loosely: it leads your hand through %n strokes. V: stop.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Watch: %n strokes. V: stop.</source>
        <translation>
            <numerusform>Watch: %n stroke. V: stop.</numerusform>
            <numerusform>Watch: %n strokes. V: stop.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::BrushReviewBar</name>
    <message numerus="yes">
        <source>a character with %n strokes</source>
        <translation>
            <numerusform>a character with %n stroke</numerusform>
            <numerusform>a character with %n strokes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::BrushWords</name>
    <message numerus="yes">
        <source>%n strokes</source>
        <translation>
            <numerusform>%n stroke</numerusform>
            <numerusform>%n strokes</numerusform>
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
    <name>nazori::ui::GrooveCurve</name>
    <message numerus="yes">
        <source>%n points. Left and Right choose one.</source>
        <translation>
            <numerusform>%n point. Left and Right choose one.</numerusform>
            <numerusform>%n points. Left and Right choose one.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::HomeView</name>
    <message numerus="yes">
        <source>%n characters were forgotten too often and taken out of reviews: %1</source>
        <translation>
            <numerusform>%n character was forgotten too often and taken out of reviews: %1</numerusform>
            <numerusform>%n characters were forgotten too often and taken out of reviews: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Write with the brush, %n characters</source>
        <translation>
            <numerusform>Write with the brush, %n character</numerusform>
            <numerusform>Write with the brush, %n characters</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::HomeWords</name>
    <message numerus="yes">
        <source>%n days in a row</source>
        <translation>
            <numerusform>%n day in a row</numerusform>
            <numerusform>%n days in a row</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n reviews</source>
        <translation>
            <numerusform>%n review</numerusform>
            <numerusform>%n reviews</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n new characters</source>
        <translation>
            <numerusform>%n new character</numerusform>
            <numerusform>%n new characters</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>about %n days</source>
        <translation>
            <numerusform>about a day</numerusform>
            <numerusform>about %n days</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>about %n weeks</source>
        <translation>
            <numerusform>about a week</numerusform>
            <numerusform>about %n weeks</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>about %n months</source>
        <translation>
            <numerusform>about a month</numerusform>
            <numerusform>about %n months</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>about %n years</source>
        <translation>
            <numerusform>about a year</numerusform>
            <numerusform>about %n years</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Done for now. %n characters come back today, the first at %1.</source>
        <translation>
            <numerusform>Done for now. %n character comes back today, at %1.</numerusform>
            <numerusform>Done for now. %n characters come back today, the first at %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Done for today: you have reached your daily limit. %n reviews will wait until tomorrow.</source>
        <translation>
            <numerusform>Done for today: you have reached your daily limit. %n review will wait until tomorrow.</numerusform>
            <numerusform>Done for today: you have reached your daily limit. %n reviews will wait until tomorrow.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Done for today. %n reviews are due tomorrow.</source>
        <translation>
            <numerusform>Done for today. %n review is due tomorrow.</numerusform>
            <numerusform>Done for today. %n reviews are due tomorrow.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n reviews are waiting. No hurry: do %1 today, starting with the characters you know best.</source>
        <translation>
            <numerusform>%n review is waiting. No hurry: do %1 today.</numerusform>
            <numerusform>%n reviews are waiting. No hurry: do %1 today, starting with the characters you know best.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>You will catch up in %n days, on %1. No new characters until then.</source>
        <translation>
            <numerusform>You will catch up in %n day, on %1. No new characters until then.</numerusform>
            <numerusform>You will catch up in %n days, on %1. No new characters until then.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more reviews will wait for another day because of your daily limit.</source>
        <translation>
            <numerusform>%n more review will wait for another day because of your daily limit.</numerusform>
            <numerusform>%n more reviews will wait for another day because of your daily limit.</numerusform>
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
    <name>nazori::ui::KnownDialog</name>
    <message numerus="yes">
        <source>%Ln characters will be marked as known. What you have studied stays as it is.</source>
        <translation>
            <numerusform>%Ln character will be marked as known. What you have studied stays as it is.</numerusform>
            <numerusform>%Ln characters will be marked as known. What you have studied stays as it is.</numerusform>
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
    <name>nazori::ui::PartWords</name>
    <message numerus="yes">
        <source>%1: strokes %2</source>
        <translation>
            <numerusform>%1: stroke %2</numerusform>
            <numerusform>%1: strokes %2</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::PeriodPicture</name>
    <message numerus="yes">
        <source>%n characters in my own hand</source>
        <translation>
            <numerusform>%n character in my own hand</numerusform>
            <numerusform>%n characters in my own hand</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n new</source>
        <translation>
            <numerusform>%n new</numerusform>
            <numerusform>%n new</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n study days</source>
        <translation>
            <numerusform>%n study day</numerusform>
            <numerusform>%n study days</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::QuestionView</name>
    <message numerus="yes">
        <source>a character with %n strokes</source>
        <translation>
            <numerusform>a character with %n stroke</numerusform>
            <numerusform>a character with %n strokes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::SearchWords</name>
    <message numerus="yes">
        <source>%n strokes</source>
        <translation>
            <numerusform>%n stroke</numerusform>
            <numerusform>%n strokes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::SessionBar</name>
    <message numerus="yes">
        <source>%n min left</source>
        <translation>
            <numerusform>%n min left</numerusform>
            <numerusform>%n min left</numerusform>
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
        <source>Stroke %1 was wrong %n times.</source>
        <translation>
            <numerusform>Stroke %1 was wrong once.</numerusform>
            <numerusform>Stroke %1 was wrong %n times.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::SessionWords</name>
    <message numerus="yes">
        <source>Undone: what you chose to learn, and %n characters marked as known.</source>
        <translation>
            <numerusform>Undone: what you chose to learn, and %n character marked as known.</numerusform>
            <numerusform>Undone: what you chose to learn, and %n characters marked as known.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::SheetCheckDialog</name>
    <message numerus="yes">
        <source>Reading %n photographs…</source>
        <translation>
            <numerusform>Reading %n photograph…</numerusform>
            <numerusform>Reading %n photographs…</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::SheetWords</name>
    <message numerus="yes">
        <source>%n cells, </source>
        <translation>
            <numerusform>%n cell, </numerusform>
            <numerusform>%n cells, </numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::StageWords</name>
    <message numerus="yes">
        <source>All %n strokes shown. Space: play again. F6: trace.</source>
        <translation>
            <numerusform>Stroke shown. Space: play again. F6: trace.</numerusform>
            <numerusform>All %n strokes shown. Space: play again. F6: trace.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>All %n strokes shown. Space: play again. Enter: trace.</source>
        <translation>
            <numerusform>Stroke shown. Space: play again. Enter: trace.</numerusform>
            <numerusform>All %n strokes shown. Space: play again. Enter: trace.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>All %n strokes written. Delete: clear the tablet.</source>
        <translation>
            <numerusform>Stroke written. Delete: clear the tablet.</numerusform>
            <numerusform>All %n strokes written. Delete: clear the tablet.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n strokes written. Enter: finish.</source>
        <translation>
            <numerusform>%n stroke written. Enter: finish.</numerusform>
            <numerusform>%n strokes written. Enter: finish.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Stroke %1 is correct. %n to go.</source>
        <translation>
            <numerusform>Stroke %1 is correct. %n to go.</numerusform>
            <numerusform>Stroke %1 is correct. %n to go.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Undone. %n strokes written.</source>
        <translation>
            <numerusform>Undone. %n stroke written.</numerusform>
            <numerusform>Undone. %n strokes written.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Write the character (%n strokes).</source>
        <translation>
            <numerusform>Write the character (%n stroke).</numerusform>
            <numerusform>Write the character (%n strokes).</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::StartPage</name>
    <message numerus="yes">
        <source>%Ln characters marked as known. Ctrl+Shift+Z: undo.</source>
        <translation>
            <numerusform>%Ln character marked as known. Ctrl+Shift+Z: undo.</numerusform>
            <numerusform>%Ln characters marked as known. Ctrl+Shift+Z: undo.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::StartView</name>
    <message numerus="yes">
        <source>%n characters: %1</source>
        <translation>
            <numerusform>%n character: %1</numerusform>
            <numerusform>%n characters: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln characters will be marked as known: %1</source>
        <translation>
            <numerusform>%Ln character will be marked as known: %1</numerusform>
            <numerusform>%Ln characters will be marked as known: %1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln characters are already studied and stay as they are.</source>
        <translation>
            <numerusform>%Ln character is already studied and stays as it is.</numerusform>
            <numerusform>%Ln characters are already studied and stay as they are.</numerusform>
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
        <source>%n characters postponed.</source>
        <translation>
            <numerusform>%n character postponed.</numerusform>
            <numerusform>%n characters postponed.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters suspended.</source>
        <translation>
            <numerusform>%n character suspended.</numerusform>
            <numerusform>%n characters suspended.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters resumed.</source>
        <translation>
            <numerusform>%n character resumed.</numerusform>
            <numerusform>%n characters resumed.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters started over as new.</source>
        <translation>
            <numerusform>%n character started over as new.</numerusform>
            <numerusform>%n characters started over as new.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>With %1 new characters a day: about %2 reviews and %n minutes a day, and about %3 characters known after a year. Higher retention means more reviews.</source>
        <translation>
            <numerusform>With %1 new characters a day: about %2 reviews and %n minute a day, and about %3 characters known after a year. Higher retention means more reviews.</numerusform>
            <numerusform>With %1 new characters a day: about %2 reviews and %n minutes a day, and about %3 characters known after a year. Higher retention means more reviews.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln characters selected, %1 of them already studied.</source>
        <translation>
            <numerusform>%Ln character selected, %1 already studied.</numerusform>
            <numerusform>%Ln characters selected, %1 of them already studied.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln characters marked as known.</source>
        <translation>
            <numerusform>%Ln character marked as known.</numerusform>
            <numerusform>%Ln characters marked as known.</numerusform>
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
    <name>nazori::ui::TablePicker</name>
    <message numerus="yes">
        <source>%n strokes</source>
        <translation>
            <numerusform>%n stroke</numerusform>
            <numerusform>%n strokes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1, %n strokes</source>
        <translation>
            <numerusform>%1, %n stroke</numerusform>
            <numerusform>%1, %n strokes</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::TraceDialog</name>
    <message numerus="yes">
        <source>%n fonts have this character.</source>
        <translation>
            <numerusform>%n font has this character.</numerusform>
            <numerusform>%n fonts have this character.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::WorksheetDialog</name>
    <message numerus="yes">
        <source>Saved %n pages as %1.</source>
        <translation>
            <numerusform>Saved %n page as %1.</numerusform>
            <numerusform>Saved %n pages as %1.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n pages</source>
        <translation>
            <numerusform>%n page</numerusform>
            <numerusform>%n pages</numerusform>
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
    <name>nazori::ui::WorkshopPage</name>
    <message numerus="yes">
        <source>Your work that was interrupted is back: %n changes.</source>
        <translation>
            <numerusform>Your work that was interrupted is back: %n change.</numerusform>
            <numerusform>Your work that was interrupted is back: %n changes.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Opened %1, with %n changes that were not saved.</source>
        <translation>
            <numerusform>Opened %1, with %n change that was not saved.</numerusform>
            <numerusform>Opened %1, with %n changes that were not saved.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n strokes found in %1.</source>
        <translation>
            <numerusform>%n stroke found in %1.</numerusform>
            <numerusform>%n strokes found in %1.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::WorkshopPanel</name>
    <message numerus="yes">
        <source>%n remarks</source>
        <translation>
            <numerusform>%n remark</numerusform>
            <numerusform>%n remarks</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::WorkshopWords</name>
    <message numerus="yes">
        <source>%n points</source>
        <translation>
            <numerusform>%n point</numerusform>
            <numerusform>%n points</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n strokes.</source>
        <translation>
            <numerusform>%n stroke.</numerusform>
            <numerusform>%n strokes.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::plot_words</name>
    <message numerus="yes">
        <source>%n branches</source>
        <translation>
            <numerusform>%n branch</numerusform>
            <numerusform>%n branches</numerusform>
        </translation>
    </message>
</context>
</TS>
