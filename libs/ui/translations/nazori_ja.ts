<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja_JP">
<context>
    <name>nazori::ui::AboutDialog</name>
    <message>
        <source>About Nazori</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Carved kanji you can see, feel and trace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Licences</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nazori, the program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strokes: KanjiVG, © Ulrich Apel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Readings, meanings and words: KANJIDIC2 and EDICT, © EDRDG</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Textbook face: Klee One, © Fontworks Inc.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Interface toolkit: Qt %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sources of the kanji database</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>nazori::ui::Actions</name>
    <message>
        <source>&amp;Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a height map (RAW, PNG) or a stroke order (.str)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the tablet as RAW, PNG or .str</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close Nazori</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Find a character</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to the search box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Next in the list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The next character of the list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Previous in the list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The character before in the list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to the character before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For&amp;ward</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Forward again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Next stroke</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the next stroke alone; after the last, all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Previous stroke</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the stroke before alone; before the first, all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;All strokes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show all strokes at once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Strokes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show or hide the strokes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>N&amp;umbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show or hide the number at each stroke&apos;s start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A&amp;rrows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show or hide the arrowheads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;nap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strokes hold the stylus, while they are shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Clear the ink</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wipe the tablet clean to write again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Wood</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pale wood</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;late</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dark stone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Classic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The look of 2005</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colours of the &amp;desktop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light or dark, as the desktop is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Light colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Always light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dar&amp;k colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Always dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Language of the des&amp;ktop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The language of the desktop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Larger text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Larger text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;maller text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smaller text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Usual text size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Text as at first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Reduced motion</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing glides, everything is there at once</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;List of characters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show or fold away the list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Information</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show or fold away the information</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only the tablet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn the tablet to the left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn the tablet to the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tilt away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look along the tablet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tilt back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look from above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the tablet to the left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the tablet to the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the tablet up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the tablet down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nearer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Farther</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Straight view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The whole tablet, straight from above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All keys and what the mouse does</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;About Nazori</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Version, licences and sources</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Character</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Tablet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>nazori::ui::FeedbackLine</name>
    <message>
        <source>What just happened</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>nazori::ui::FileExchange</name>
    <message>
        <source>The character</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2. The tablet is as it was.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a height map, a stroke order, or both</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height maps and stroke orders (*.raw *.png *.str);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is one too many: open one height map and one stroke order. The tablet is as it was.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is neither RAW, PNG nor .str. The tablet is as it was.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size of the grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 does not say how large its grid is.
Columns and rows:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no tablet to save yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>nazori::ui::InformationPanel</name>
    <message>
        <source>About the character</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kun reading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Radical</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Words</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Your own tablet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 × %1 samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n strokes</source>
        <translation type="unfinished">
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Hiragana</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Katakana</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Letter or digit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No meaning is recorded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 here, %2 in the dictionary</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>grade %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>secondary school</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>for names</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of 2,501 in newspapers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>old JLPT %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The kanji stands for %1; %2 follows it in kana</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, a form of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. Go there</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>nazori::ui::KeyListDialog</name>
    <message>
        <source>Keys and mouse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On the tablet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stylus down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left button, pen tip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deeper, less deep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wheel while pressed, pen pressure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn and tilt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>right button, pen&apos;s side button</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>middle button, or right with Shift</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nearer, farther</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wheel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Straight view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Home</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>nazori::ui::LibraryPanel</name>
    <message>
        <source>Characters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>休, yasumu, rest …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find a character</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find a character by itself, by a reading in kana or romaji, or by an English meaning (Ctrl+F)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grade 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grade 2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grade 3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grade 4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grade 5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grade 6</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Secondary school</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For names</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hiragana</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Katakana</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Letters and digits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All characters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>List of characters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Characters of the list</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n found</source>
        <translation type="unfinished">
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters</source>
        <translation type="unfinished">
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing found for “%1”. Try a character (休), a reading (やすむ, yasumu) or the beginning of an English meaning (rest).</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>nazori::ui::MainWindow</name>
    <message>
        <source>The tablet cannot be drawn here: OpenGL 3.3 is missing. The package libgl1-mesa-dri draws it on any computer. Lists and information work.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Carved tablet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The character as grooves to be traced: the left button presses the stylus down, the right button turns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The settings could not be saved in %1. They hold until Nazori is closed.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The kanji database: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 has no strokes in the database. The tablet is as it was.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The tablet cannot be drawn: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The stylus does not work: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 – Nazori</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is on the desk.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is on the desk. A .str file adds its strokes.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>nazori::ui::Program</name>
    <message>
        <source>Nazori cannot start: %1.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>nazori::ui::SaveDialog</name>
    <message>
        <source>Save the tablet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height map, 8-bit RAW as in 2005</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height map, 16-bit PNG</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stroke order, .str as in 2005</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 × %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 × %1, as in 2005</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height maps (*.raw)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stroke orders (*.str)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>nazori::ui::StatusLine</name>
    <message>
        <source>How often a second the stylus is felt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Moments of feeling that came too late or not at all, since the start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mouse or pen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, without force</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>depth %1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 times a second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>starting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 missed</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>nazori::ui::StrokeTeller</name>
    <message>
        <source>Press the left button to touch the tablet; the right button turns it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press the left button in a groove and follow it. S shows the strokes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold the left button at number 1 and draw along the groove.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stroke %1: follow the groove to its end.</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>All %n strokes are written. Delete clears the tablet.</source>
        <translation type="unfinished">
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Stroke %1 is written. The full stop key (.) shows the next.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stroke %1 is written. Stroke %2 is next.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stroke %1 comes before stroke %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stroke %1 begins at its other end, where its number stands.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The stylus is free.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strokes hold the stylus only while they are shown: press S.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strokes now hold the stylus. Pull away firmly to leave one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stroke %1 is chosen, but the strokes are hidden: press S.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stroke %1 of %2. Draw it from its number.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>nazori::ui::ToolBar</name>
    <message>
        <source>Strokes and tablet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no strokes</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>all %n strokes</source>
        <translation type="unfinished">
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>stroke %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
