<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja_JP">
<context>
    <name>nazori::ui::AboutDialog</name>
    <message>
        <source>About Nazori</source>
        <translation>Nazori について</translation>
    </message>
    <message>
        <source>Carved kanji you can see, feel and trace</source>
        <translation>見て、触れて、なぞれる、彫られた漢字</translation>
    </message>
    <message>
        <source>Licences</source>
        <translation>ライセンス</translation>
    </message>
    <message>
        <source>Nazori, the program</source>
        <translation>プログラム Nazori</translation>
    </message>
    <message>
        <source>Strokes: KanjiVG, © Ulrich Apel</source>
        <translation>筆画：KanjiVG © Ulrich Apel</translation>
    </message>
    <message>
        <source>Readings, meanings and words: KANJIDIC2 and EDICT, © EDRDG</source>
        <translation>読み・意味・熟語：KANJIDIC2、EDICT © EDRDG</translation>
    </message>
    <message>
        <source>Textbook face: Klee One, © Fontworks Inc.</source>
        <translation>教科書風の書体：クレー One © Fontworks Inc.</translation>
    </message>
    <message>
        <source>Interface toolkit: Qt %1</source>
        <translation>画面部品：Qt %1</translation>
    </message>
    <message>
        <source>Sources of the kanji database</source>
        <translation>漢字データベースの出典</translation>
    </message>
</context>
<context>
    <name>nazori::ui::Actions</name>
    <message>
        <source>&amp;Open…</source>
        <translation>開く(&amp;O)…</translation>
    </message>
    <message>
        <source>Open a height map (RAW, PNG) or a stroke order (.str)</source>
        <translation>高さマップ（RAW、PNG）または筆順（.str）を開きます</translation>
    </message>
    <message>
        <source>&amp;Save as…</source>
        <translation>名前を付けて保存(&amp;S)…</translation>
    </message>
    <message>
        <source>Save the tablet as RAW, PNG or .str</source>
        <translation>文字板を RAW、PNG、.str で保存します</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>終了(&amp;Q)</translation>
    </message>
    <message>
        <source>Close Nazori</source>
        <translation>Nazori を閉じます</translation>
    </message>
    <message>
        <source>&amp;Wood</source>
        <translation>木(&amp;W)</translation>
    </message>
    <message>
        <source>Pale wood</source>
        <translation>白木の板</translation>
    </message>
    <message>
        <source>S&amp;late</source>
        <translation>石(&amp;L)</translation>
    </message>
    <message>
        <source>Dark stone</source>
        <translation>黒い石の板</translation>
    </message>
    <message>
        <source>&amp;Classic</source>
        <translation>2005年風(&amp;C)</translation>
    </message>
    <message>
        <source>The look of 2005</source>
        <translation>2005年のプログラムの見た目</translation>
    </message>
    <message>
        <source>Colours of the &amp;desktop</source>
        <translation>デスクトップの配色(&amp;D)</translation>
    </message>
    <message>
        <source>Light or dark, as the desktop is</source>
        <translation>明暗をデスクトップに合わせます</translation>
    </message>
    <message>
        <source>&amp;Light colours</source>
        <translation>明るい配色(&amp;L)</translation>
    </message>
    <message>
        <source>Always light</source>
        <translation>いつも明るく</translation>
    </message>
    <message>
        <source>Dar&amp;k colours</source>
        <translation>暗い配色(&amp;K)</translation>
    </message>
    <message>
        <source>Always dark</source>
        <translation>いつも暗く</translation>
    </message>
    <message>
        <source>Language of the des&amp;ktop</source>
        <translation>デスクトップの言語(&amp;K)</translation>
    </message>
    <message>
        <source>The language of the desktop</source>
        <translation>デスクトップの言語に合わせます</translation>
    </message>
    <message>
        <source>&amp;Larger text</source>
        <translation>文字を大きく(&amp;L)</translation>
    </message>
    <message>
        <source>Larger text</source>
        <translation>文字を大きくします</translation>
    </message>
    <message>
        <source>S&amp;maller text</source>
        <translation>文字を小さく(&amp;M)</translation>
    </message>
    <message>
        <source>Smaller text</source>
        <translation>文字を小さくします</translation>
    </message>
    <message>
        <source>&amp;Usual text size</source>
        <translation>標準の文字サイズ(&amp;U)</translation>
    </message>
    <message>
        <source>Text as at first</source>
        <translation>文字を初めの大きさに戻します</translation>
    </message>
    <message>
        <source>&amp;Reduced motion</source>
        <translation>動きを減らす(&amp;R)</translation>
    </message>
    <message>
        <source>Nothing glides, everything is there at once</source>
        <translation>滑るような動きをやめ、すぐに切り替えます</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>全画面(&amp;F)</translation>
    </message>
    <message>
        <source>Only the tablet</source>
        <translation>文字板だけにします</translation>
    </message>
    <message>
        <source>Turn left</source>
        <translation>左へ回す</translation>
    </message>
    <message>
        <source>Turn the tablet to the left</source>
        <translation>文字板を左へ回します</translation>
    </message>
    <message>
        <source>Turn right</source>
        <translation>右へ回す</translation>
    </message>
    <message>
        <source>Turn the tablet to the right</source>
        <translation>文字板を右へ回します</translation>
    </message>
    <message>
        <source>Tilt away</source>
        <translation>寝かせる</translation>
    </message>
    <message>
        <source>Look along the tablet</source>
        <translation>文字板を斜めから見ます</translation>
    </message>
    <message>
        <source>Tilt back</source>
        <translation>起こす</translation>
    </message>
    <message>
        <source>Look from above</source>
        <translation>文字板を真上から見ます</translation>
    </message>
    <message>
        <source>Move left</source>
        <translation>左へ動かす</translation>
    </message>
    <message>
        <source>Move the tablet to the left</source>
        <translation>文字板を左へ動かします</translation>
    </message>
    <message>
        <source>Move right</source>
        <translation>右へ動かす</translation>
    </message>
    <message>
        <source>Move the tablet to the right</source>
        <translation>文字板を右へ動かします</translation>
    </message>
    <message>
        <source>Move up</source>
        <translation>上へ動かす</translation>
    </message>
    <message>
        <source>Move the tablet up</source>
        <translation>文字板を上へ動かします</translation>
    </message>
    <message>
        <source>Move down</source>
        <translation>下へ動かす</translation>
    </message>
    <message>
        <source>Move the tablet down</source>
        <translation>文字板を下へ動かします</translation>
    </message>
    <message>
        <source>Nearer</source>
        <translation>近づく</translation>
    </message>
    <message>
        <source>Farther</source>
        <translation>遠ざかる</translation>
    </message>
    <message>
        <source>&amp;Straight view</source>
        <translation>正面に戻す(&amp;S)</translation>
    </message>
    <message>
        <source>The whole tablet, straight from above</source>
        <translation>文字板全体を正面から見ます</translation>
    </message>
    <message>
        <source>&amp;Keys</source>
        <translation>キー一覧(&amp;K)</translation>
    </message>
    <message>
        <source>All keys and what the mouse does</source>
        <translation>すべてのキーとマウスの働き</translation>
    </message>
    <message>
        <source>&amp;About Nazori</source>
        <translation>Nazori について(&amp;A)</translation>
    </message>
    <message>
        <source>Version, licences and sources</source>
        <translation>バージョン、ライセンス、出典</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>ファイル(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Tablet</source>
        <translation>文字板(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>表示(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>ヘルプ(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Go</source>
        <translation>移動(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Record the session</source>
        <translation>記録する(&amp;R)</translation>
    </message>
    <message>
        <source>Write every moment of feeling to a file</source>
        <translation>触った一瞬一瞬をファイルに書き留めます</translation>
    </message>
    <message>
        <source>Groove s&amp;ound</source>
        <translation>溝の音(&amp;O)</translation>
    </message>
    <message>
        <source>Hear the stylus scratch in the groove</source>
        <translation>ペン先が溝をこする音を鳴らします</translation>
    </message>
    <message>
        <source>Lo&amp;uder</source>
        <translation>音を大きく(&amp;U)</translation>
    </message>
    <message>
        <source>The scratch becomes louder</source>
        <translation>こする音を大きくします</translation>
    </message>
    <message>
        <source>So&amp;fter</source>
        <translation>音を小さく(&amp;F)</translation>
    </message>
    <message>
        <source>The scratch becomes softer</source>
        <translation>こする音を小さくします</translation>
    </message>
    <message>
        <source>Mouse feels s&amp;lopes</source>
        <translation>マウスで坂を感じる(&amp;L)</translation>
    </message>
    <message>
        <source>The stylus of the mouse goes slower up a slope and faster down, as if held in the groove</source>
        <translation>マウスのペン先が上り坂で遅く、下り坂で速くなり、溝に留まるように感じられます</translation>
    </message>
    <message>
        <source>More</source>
        <translation>その他</translation>
    </message>
</context>
<context>
    <name>nazori::ui::AnkiDialog</name>
    <message>
        <source>Export for Anki</source>
        <translation>Anki 用に書き出す</translation>
    </message>
    <message>
        <source>Choose the file…</source>
        <translation>ファイルを選ぶ…</translation>
    </message>
    <message>
        <source>&amp;Characters</source>
        <translation>文字(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Deck</source>
        <translation>デッキ(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Words to a character</source>
        <translation>一字あたりの語数(&amp;W)</translation>
    </message>
</context>
<context>
    <name>nazori::ui::BackupsDialog</name>
    <message>
        <source>Daily</source>
        <translation>毎日</translation>
    </message>
    <message>
        <source>Made by you</source>
        <translation>自分で作成</translation>
    </message>
    <message>
        <source>What a restored one replaced</source>
        <translation>復元の前のもの</translation>
    </message>
    <message>
        <source>Before a newer version</source>
        <translation>新しい版になる前のもの</translation>
    </message>
    <message>
        <source>Backups of %1</source>
        <translation>%1 のバックアップ</translation>
    </message>
    <message>
        <source>Backups, the newest first</source>
        <translation>バックアップ（新しい順）</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>Last day in it</source>
        <translation>最後の日</translation>
    </message>
    <message>
        <source>Writings</source>
        <translation>書いた回数</translation>
    </message>
    <message>
        <source>Characters</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>&amp;Back up now</source>
        <translation>今すぐバックアップ(&amp;B)</translation>
    </message>
    <message>
        <source>&amp;Put it in place…</source>
        <translation>これに戻す(&amp;P)…</translation>
    </message>
    <message>
        <source>There is no backup yet. One is made by itself on each day of study, when Nazori opens.</source>
        <translation>バックアップはまだありません。学習した日ごとに、なぞりを開いたとき自動で一つ作られます。</translation>
    </message>
    <message>
        <source>One is made by itself on each day of study; seven are kept. Of what a backup replaced, the last three are kept.</source>
        <translation>学習した日ごとに自動で一つ作られ、七つまで残ります。復元で置き換えられたものは最新の三つが残ります。</translation>
    </message>
    <message>
        <source>cannot be used</source>
        <translation>使えません</translation>
    </message>
    <message>
        <source>%1, last day %2, writings %3, characters %4</source>
        <translation>%1、最後の日 %2、書いた回数 %3、文字 %4</translation>
    </message>
    <message>
        <source>Restore from a backup</source>
        <translation>バックアップから戻す</translation>
    </message>
    <message>
        <source>Put this backup in the place of what %1 has done so far? %2</source>
        <translation>%1 のこれまでの記録を、このバックアップに置き換えますか。%2</translation>
    </message>
    <message>
        <source>What stands there now is kept as a backup, so this can be taken back.</source>
        <translation>今の記録はバックアップとして残るので、元に戻せます。</translation>
    </message>
    <message>
        <source>&amp;Put it in place</source>
        <translation>これに戻す(&amp;P)</translation>
    </message>
    <message>
        <source>Of %1</source>
        <translation>%1 のもの</translation>
    </message>
</context>
<context>
    <name>nazori::ui::CharacterActions</name>
    <message>
        <source>&amp;More leniently</source>
        <translation>もっと甘く(&amp;M)</translation>
    </message>
    <message>
        <source>Judge a little more leniently</source>
        <translation>少し甘く採点します</translation>
    </message>
    <message>
        <source>More str&amp;ictly</source>
        <translation>もっと厳しく(&amp;I)</translation>
    </message>
    <message>
        <source>Judge a little more strictly</source>
        <translation>少し厳しく採点します</translation>
    </message>
    <message>
        <source>&amp;Find a character</source>
        <translation>文字を探す(&amp;F)</translation>
    </message>
    <message>
        <source>Go to the search box</source>
        <translation>検索欄へ移ります</translation>
    </message>
    <message>
        <source>&amp;Next in the list</source>
        <translation>一覧の次の字(&amp;N)</translation>
    </message>
    <message>
        <source>The next character of the list</source>
        <translation>一覧の次の字へ</translation>
    </message>
    <message>
        <source>&amp;Previous in the list</source>
        <translation>一覧の前の字(&amp;P)</translation>
    </message>
    <message>
        <source>The character before in the list</source>
        <translation>一覧の前の字へ</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>戻る(&amp;B)</translation>
    </message>
    <message>
        <source>Back to the character before</source>
        <translation>さっきの字へ戻ります</translation>
    </message>
    <message>
        <source>For&amp;ward</source>
        <translation>進む(&amp;W)</translation>
    </message>
    <message>
        <source>Forward again</source>
        <translation>また先へ進みます</translation>
    </message>
    <message>
        <source>&amp;Next stroke</source>
        <translation>次の画(&amp;N)</translation>
    </message>
    <message>
        <source>Show the next stroke alone; after the last, all</source>
        <translation>次の画だけを見せます。最後の画の次は全画です</translation>
    </message>
    <message>
        <source>&amp;Previous stroke</source>
        <translation>前の画(&amp;P)</translation>
    </message>
    <message>
        <source>Show the stroke before alone; before the first, all</source>
        <translation>前の画だけを見せます。最初の画の前は全画です</translation>
    </message>
    <message>
        <source>&amp;All strokes</source>
        <translation>全画(&amp;A)</translation>
    </message>
    <message>
        <source>Show all strokes at once</source>
        <translation>すべての画を一度に見せます</translation>
    </message>
    <message>
        <source>&amp;Strokes</source>
        <translation>筆画(&amp;S)</translation>
    </message>
    <message>
        <source>Show or hide the strokes</source>
        <translation>筆画の線を見せる／隠す</translation>
    </message>
    <message>
        <source>N&amp;umbers</source>
        <translation>番号(&amp;U)</translation>
    </message>
    <message>
        <source>Show or hide the number at each stroke&apos;s start</source>
        <translation>書き始めの番号を見せる／隠す</translation>
    </message>
    <message>
        <source>A&amp;rrows</source>
        <translation>矢印(&amp;R)</translation>
    </message>
    <message>
        <source>Show or hide the arrowheads</source>
        <translation>矢印を見せる／隠す</translation>
    </message>
    <message>
        <source>S&amp;nap</source>
        <translation>吸着(&amp;N)</translation>
    </message>
    <message>
        <source>Strokes hold the stylus, while they are shown</source>
        <translation>見えている画がペン先を引き留めます</translation>
    </message>
    <message>
        <source>&amp;Clear the ink</source>
        <translation>墨を消す(&amp;C)</translation>
    </message>
    <message>
        <source>Wipe the tablet clean to write again</source>
        <translation>文字板をきれいにして、もう一度書けるようにします</translation>
    </message>
    <message>
        <source>&amp;Character</source>
        <translation>文字(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Draw to find</source>
        <translation>書いて探す(&amp;D)</translation>
    </message>
    <message>
        <source>Find a character by drawing it</source>
        <translation>字を書いて探します</translation>
    </message>
    <message>
        <source>&amp;Watch</source>
        <translation>見る(&amp;W)</translation>
    </message>
    <message>
        <source>A brush writes the character stroke by stroke</source>
        <translation>筆が一画ずつ字を書きます</translation>
    </message>
    <message>
        <source>&amp;Trace</source>
        <translation>なぞる(&amp;T)</translation>
    </message>
    <message>
        <source>Trace the grooves, with lines and numbers</source>
        <translation>線と番号を見ながら溝をなぞります</translation>
    </message>
    <message>
        <source>&amp;Guided</source>
        <translation>導かれて書く(&amp;G)</translation>
    </message>
    <message>
        <source>Only the groove, or only where strokes start; strokes hold the stylus</source>
        <translation>溝だけ、または書き始めだけを頼りに書きます。画がペン先を引き留めます</translation>
    </message>
    <message>
        <source>&amp;Memory</source>
        <translation>覚えて書く(&amp;M)</translation>
    </message>
    <message>
        <source>Write on a blank tablet, and be judged</source>
        <translation>何もない文字板に書き、判定を受けます</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>再生(&amp;P)</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>再生／一時停止</translation>
    </message>
    <message>
        <source>Stroke &amp;back</source>
        <translation>一画戻る(&amp;B)</translation>
    </message>
    <message>
        <source>Back to the start of the stroke</source>
        <translation>画の初めに戻ります</translation>
    </message>
    <message>
        <source>Stroke &amp;on</source>
        <translation>一画進む(&amp;O)</translation>
    </message>
    <message>
        <source>On to the end of the stroke</source>
        <translation>画の終わりに進みます</translation>
    </message>
    <message>
        <source>&amp;Slower</source>
        <translation>遅く(&amp;S)</translation>
    </message>
    <message>
        <source>Slower</source>
        <translation>遅くします</translation>
    </message>
    <message>
        <source>&amp;Faster</source>
        <translation>速く(&amp;F)</translation>
    </message>
    <message>
        <source>Faster</source>
        <translation>速くします</translation>
    </message>
    <message>
        <source>&amp;Loop</source>
        <translation>くり返す(&amp;L)</translation>
    </message>
    <message>
        <source>Begin again at the end</source>
        <translation>終わったら初めから</translation>
    </message>
    <message>
        <source>Only the g&amp;roove</source>
        <translation>溝だけ(&amp;R)</translation>
    </message>
    <message>
        <source>The groove leads, without lines</source>
        <translation>線なしで、溝が導きます</translation>
    </message>
    <message>
        <source>Only the &amp;starts</source>
        <translation>書き始めだけ(&amp;S)</translation>
    </message>
    <message>
        <source>Numbers say where strokes start</source>
        <translation>番号が書き始めを示します</translation>
    </message>
    <message>
        <source>&amp;Undo the stroke</source>
        <translation>一画取り消す(&amp;U)</translation>
    </message>
    <message>
        <source>Take back the last stroke</source>
        <translation>最後の画を取り消します</translation>
    </message>
    <message>
        <source>&amp;Done</source>
        <translation>できた(&amp;D)</translation>
    </message>
    <message>
        <source>Judge what is written</source>
        <translation>書いた字を判定します</translation>
    </message>
    <message>
        <source>&amp;Hint</source>
        <translation>ヒント(&amp;H)</translation>
    </message>
    <message>
        <source>Show the next stroke; asked again, all of them</source>
        <translation>次の画を見せます。もう一度押すと残り全部です</translation>
    </message>
    <message>
        <source>Gi&amp;ve up</source>
        <translation>あきらめる(&amp;V)</translation>
    </message>
    <message>
        <source>Show the character</source>
        <translation>字を見せます</translation>
    </message>
    <message>
        <source>&amp;Judge each stroke</source>
        <translation>一画ごとに判定(&amp;J)</translation>
    </message>
    <message>
        <source>Judge every stroke as it ends, or all at the end</source>
        <translation>一画ごとに判定するか、最後にまとめて判定するか</translation>
    </message>
    <message>
        <source>Tablet: &amp;blank</source>
        <translation>文字板：溝なし(&amp;B)</translation>
    </message>
    <message>
        <source>No groove is shown</source>
        <translation>溝を見せません</translation>
    </message>
    <message>
        <source>Tablet: groo&amp;ve</source>
        <translation>文字板：溝あり(&amp;V)</translation>
    </message>
    <message>
        <source>The groove is shown</source>
        <translation>溝を見せます</translation>
    </message>
    <message>
        <source>Tablet: groove &amp;after each stroke</source>
        <translation>文字板：書けた画から溝が現れる(&amp;A)</translation>
    </message>
    <message>
        <source>The groove of each stroke appears when it is written right</source>
        <translation>正しく書けた画の溝が現れます</translation>
    </message>
    <message>
        <source>L&amp;enient</source>
        <translation>やさしく(&amp;E)</translation>
    </message>
    <message>
        <source>Judge leniently</source>
        <translation>やさしく判定します</translation>
    </message>
    <message>
        <source>N&amp;ormal</source>
        <translation>ふつう(&amp;O)</translation>
    </message>
    <message>
        <source>Judge as a teacher does</source>
        <translation>先生のように判定します</translation>
    </message>
    <message>
        <source>St&amp;rict</source>
        <translation>きびしく(&amp;R)</translation>
    </message>
    <message>
        <source>Judge strictly</source>
        <translation>きびしく判定します</translation>
    </message>
    <message>
        <source>Model o&amp;ver the writing</source>
        <translation>手本を重ねる(&amp;V)</translation>
    </message>
    <message>
        <source>Lay the model over what is written</source>
        <translation>書いた字に手本を重ねます</translation>
    </message>
    <message>
        <source>Writing beside the &amp;model</source>
        <translation>手本と並べる(&amp;M)</translation>
    </message>
    <message>
        <source>Show writing and model side by side, and replay both</source>
        <translation>書いた字と手本を並べ、両方を再生します</translation>
    </message>
    <message>
        <source>&amp;Practice</source>
        <translation>練習(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Lead the hand</source>
        <translation>手を導く(&amp;L)</translation>
    </message>
    <message>
        <source>A device with force takes the hand along; else strokes hold it</source>
        <translation>力覚デバイスが手を導く。ほかでは画が引き寄せる</translation>
    </message>
    <message>
        <source>&amp;Writing</source>
        <translation>書く(&amp;W)</translation>
    </message>
</context>
<context>
    <name>nazori::ui::Characters</name>
    <message>
        <source>&amp;Characters</source>
        <translation>文字(&amp;C)</translation>
    </message>
    <message>
        <source>Carved characters to see, feel and write</source>
        <translation>彫られた文字を見て、触れて、書きます</translation>
    </message>
    <message>
        <source>&amp;List of characters</source>
        <translation>文字の一覧(&amp;L)</translation>
    </message>
    <message>
        <source>Show or fold away the list</source>
        <translation>一覧を出す／たたむ</translation>
    </message>
    <message>
        <source>&amp;Information</source>
        <translation>字の情報(&amp;I)</translation>
    </message>
    <message>
        <source>Show or fold away the information</source>
        <translation>字の情報を出す／たたむ</translation>
    </message>
    <message>
        <source>The character as grooves to be traced: the left button presses the stylus down, the right button turns</source>
        <translation>溝になった字をなぞります。左ボタンでペン先を下ろし、右ボタンで回します</translation>
    </message>
    <message>
        <source>%1 has no strokes in the database. The tablet is as it was.</source>
        <translation>「%1」の筆画はデータベースにありません。文字板は元のままです。</translation>
    </message>
    <message>
        <source>%1 is on the desk.</source>
        <translation>%1 を開きました。</translation>
    </message>
    <message>
        <source>%1 is on the desk. A .str file adds its strokes.</source>
        <translation>%1 を開きました。.str ファイルを開くと筆画が加わります。</translation>
    </message>
    <message>
        <source>Write from memory</source>
        <translation>覚えて書く</translation>
    </message>
    <message>
        <source>%1 comes tomorrow.</source>
        <translation>%1 は明日出ます。</translation>
    </message>
    <message>
        <source>%1 comes again.</source>
        <translation>%1 はまた出ます。</translation>
    </message>
    <message>
        <source>%1 is paused until it is resumed.</source>
        <translation>%1 は再開するまで休みです。</translation>
    </message>
    <message>
        <source>%1 is new again. Ctrl+Shift+Z takes it back.</source>
        <translation>%1 は新しい文字に戻りました。Ctrl+Shift+Z で取り消せます。</translation>
    </message>
    <message>
        <source>Closed. What lies on the tablet stays.</source>
        <translation>閉じました。文字板はそのままです。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::CharactersCard</name>
    <message>
        <source>The list cannot be read: %1</source>
        <translation>リストを読めません：%1</translation>
    </message>
    <message>
        <source>Which characters</source>
        <translation>どの文字</translation>
    </message>
    <message>
        <source>Every character</source>
        <translation>文字ごとの状態</translation>
    </message>
    <message>
        <source>Characters you have met stand here, each with how firmly you know it.</source>
        <translation>学んだ文字がここに並び、どれほど身についたかがわかります。</translation>
    </message>
    <message>
        <source>Character</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>強さ</translation>
    </message>
    <message>
        <source>Chance to recall it now</source>
        <translation>いま思い出せる見込み</translation>
    </message>
    <message>
        <source>%1. Enter opens a character.</source>
        <translation>%1。Enter で文字を開きます。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::ChartCard</name>
    <message>
        <source>Numbers</source>
        <translation>数字</translation>
    </message>
    <message>
        <source>The same as a table (N)</source>
        <translation>同じものを表で (N)</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>コピー</translation>
    </message>
    <message>
        <source>Copy the numbers (Ctrl+C)</source>
        <translation>数字をコピー (Ctrl+C)</translation>
    </message>
    <message>
        <source>%1 Left and right go from row to row, N shows all numbers.</source>
        <translation>%1 左右のキーで一行ずつ読み、N ですべての数字を表示します。</translation>
    </message>
    <message>
        <source>Numbers of %1</source>
        <translation>%1の数字</translation>
    </message>
    <message>
        <source>Copy the numbers of %1</source>
        <translation>%1の数字をコピー</translation>
    </message>
    <message>
        <source>Left and right read it row by row.</source>
        <translation>左右のキーで一行ずつ読みます。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::CompareView</name>
    <message>
        <source>Your writing beside the model</source>
        <translation>書いた字と手本</translation>
    </message>
    <message>
        <source>yours</source>
        <translation>あなたの字</translation>
    </message>
    <message>
        <source>model</source>
        <translation>手本</translation>
    </message>
</context>
<context>
    <name>nazori::ui::DeviceActions</name>
    <message>
        <source>&amp;Look for devices</source>
        <translation>装置を探す(&amp;L)</translation>
    </message>
    <message>
        <source>Look again for what is plugged in</source>
        <translation>つながっている装置をもう一度探します</translation>
    </message>
    <message>
        <source>S&amp;tronger</source>
        <translation>強く(&amp;T)</translation>
    </message>
    <message>
        <source>The trial pushes harder by a tenth of the device&apos;s limit</source>
        <translation>試し触りの力を、装置の上限の一割だけ強くします</translation>
    </message>
    <message>
        <source>&amp;Weaker</source>
        <translation>弱く(&amp;W)</translation>
    </message>
    <message>
        <source>The trial pushes less hard</source>
        <translation>試し触りの力を弱くします</translation>
    </message>
    <message>
        <source>Fit by &amp;corners…</source>
        <translation>四隅で合わせる(&amp;C)…</translation>
    </message>
    <message>
        <source>Show three corners of the tablet with the stylus</source>
        <translation>文字板の三つの隅をペン先で示します</translation>
    </message>
    <message>
        <source>&amp;Fit by itself</source>
        <translation>自動で合わせる(&amp;F)</translation>
    </message>
    <message>
        <source>The largest tablet that the stylus can reach whole</source>
        <translation>ペン先が隅まで届くいちばん大きな文字板にします</translation>
    </message>
    <message>
        <source>&amp;Device</source>
        <translation>装置(&amp;D)</translation>
    </message>
</context>
<context>
    <name>nazori::ui::DevicePlace</name>
    <message>
        <source>&amp;Device</source>
        <translation>装置(&amp;D)</translation>
    </message>
    <message>
        <source>What the tablet is felt with, and what it is made of</source>
        <translation>文字板に触れる装置と、文字板の材質</translation>
    </message>
    <message>
        <source>&amp;Devices</source>
        <translation>装置の一覧(&amp;D)</translation>
    </message>
    <message>
        <source>Show or fold away the devices</source>
        <translation>装置の一覧を出す／たたむ</translation>
    </message>
    <message>
        <source>&amp;What is felt</source>
        <translation>手ごたえ(&amp;W)</translation>
    </message>
    <message>
        <source>Show or fold away what is felt</source>
        <translation>手ごたえを出す／たたむ</translation>
    </message>
    <message>
        <source>A tablet to try the stylus on: a wall on the left, a groove on the right</source>
        <translation>ペン先を試す文字板。左に壁、右に溝があります</translation>
    </message>
    <message>
        <source>Feel the wall and the groove gently. It becomes stronger only when you ask for it.</source>
        <translation>壁と溝にそっと触れてみてください。力は頼んだときだけ強くなります。</translation>
    </message>
    <message>
        <source>Mouse and pen see the wall and the groove. A device with force is felt as soon as it is plugged in.</source>
        <translation>マウスとペンでは壁と溝が見えます。力覚装置をつなぐと、すぐに手ごたえが伝わります。</translation>
    </message>
    <message>
        <source>The tablet is as large as the stylus can reach.</source>
        <translation>文字板をペン先の届く範囲いっぱいに合わせました。</translation>
    </message>
    <message>
        <source>%1 goes on. What was written is still there.</source>
        <translation>%1 を再開します。書いたものはそのまま残っています。</translation>
    </message>
    <message>
        <source>%1 has the tablet.</source>
        <translation>%1 で文字板に触れています。</translation>
    </message>
    <message>
        <source>%1 Until then %2 has the tablet.</source>
        <translation>%1それまでは %2 で文字板に触れています。</translation>
    </message>
    <message>
        <source>The tablet stands as you set it.</source>
        <translation>文字板を設定どおりの向きにしました。</translation>
    </message>
    <message>
        <source>%1 Until then mouse and pen write.</source>
        <translation>%1それまではマウスとペンで書けます。</translation>
    </message>
    <message>
        <source>There is no device to be fitted.</source>
        <translation>合わせる装置がありません。</translation>
    </message>
    <message>
        <source>1 of 3: hold the tip where the bottom left corner is to be.</source>
        <translation>1／3：左下の隅にしたい所にペン先を置いてください。</translation>
    </message>
    <message>
        <source>Show three corners of the tablet in the air or on the desk.</source>
        <translation>空中か机の上で、文字板の三つの隅を示してください。</translation>
    </message>
    <message>
        <source>The device went away. The tablet is as it was.</source>
        <translation>装置がなくなりました。文字板は元のままです。</translation>
    </message>
    <message>
        <source>2 of 3: hold the tip where the bottom right corner is to be.</source>
        <translation>2／3：右下の隅にしたい所にペン先を置いてください。</translation>
    </message>
    <message>
        <source>3 of 3: hold the tip where the top left corner is to be.</source>
        <translation>3／3：左上の隅にしたい所にペン先を置いてください。</translation>
    </message>
    <message>
        <source>These corners make no tablet: they must be at least 2 cm apart, square, and in order. The tablet is as it was.</source>
        <translation>この三隅では文字板になりません。2 cm 以上離し、直角に、順番どおりに示してください。文字板は元のままです。</translation>
    </message>
    <message>
        <source>The tablet stands where you showed it.</source>
        <translation>示した所に文字板を置きました。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::DeviceText</name>
    <message>
        <source>Mouse, pen or finger</source>
        <translation>マウス・ペン・指</translation>
    </message>
    <message>
        <source>Joysticks, wheels and gamepads</source>
        <translation>ジョイスティック・ハンドル・ゲームパッド</translation>
    </message>
    <message>
        <source>Simulations</source>
        <translation>模擬装置</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>%1: the maker&apos;s library is not installed.</source>
        <translation>%1：製造元のライブラリーが入っていません。</translation>
    </message>
    <message>
        <source>%1: the maker&apos;s library is too old or not the right one. Install a newer one.</source>
        <translation>%1：製造元のライブラリーが古いか、別物です。新しいものを入れてください。</translation>
    </message>
    <message>
        <source>%1: the maker&apos;s service does not answer. Start it.</source>
        <translation>%1：製造元のサービスが応答しません。起動してください。</translation>
    </message>
    <message>
        <source>%1: nothing is plugged in. Check cable and power.</source>
        <translation>%1：何もつながっていません。ケーブルと電源を確かめてください。</translation>
    </message>
    <message>
        <source>%1 is there, but you may not open it. Add yourself to its group, or install its udev rule.</source>
        <translation>%1 はありますが、開く権限がありません。装置のグループに加わるか、udev 規則を入れてください。</translation>
    </message>
    <message>
        <source>%1 is in use. Close the other program.</source>
        <translation>%1 は使用中です。もう一方のプログラムを閉じてください。</translation>
    </message>
    <message>
        <source>%1 is there but does not start. Unplug it and plug it in again.</source>
        <translation>%1 はありますが、動き出しません。抜いてもう一度つないでください。</translation>
    </message>
    <message>
        <source>%1: how the tablet was fitted cannot be used. Fit it again.</source>
        <translation>%1：文字板の合わせ方が使えません。もう一度合わせてください。</translation>
    </message>
    <message>
        <source>%1 rests in its inkwell. Take the stylus out to go on.</source>
        <translation>%1 はペン立てに収まっています。ペンを取ると続きます。</translation>
    </message>
    <message>
        <source>%1 gives no force: its safety switch is not held.</source>
        <translation>%1 は力を出していません。安全スイッチが押されていません。</translation>
    </message>
    <message>
        <source>%1 is not calibrated. Move the stylus through all of its space, or use the maker&apos;s program.</source>
        <translation>%1 は位置合わせが要ります。ペンを動かせる範囲いっぱいに動かすか、メーカーのプログラムで合わせてください。</translation>
    </message>
    <message>
        <source>%1 is not calibrated. Put the stylus into its inkwell for a moment.</source>
        <translation>%1 は位置合わせが要ります。ペンを一度ペン立てに戻してください。</translation>
    </message>
    <message>
        <source>%1 is not calibrated. Hold the arm at its reset position and press a button of the stylus.</source>
        <translation>%1 は位置合わせが要ります。アームをリセット位置に合わせ、ペンのボタンを押してください。</translation>
    </message>
    <message>
        <source>%1 was not at rest when it was opened. Put its handle to rest and choose it again.</source>
        <translation>%1 は開いたときに休止位置にありませんでした。ハンドルを休止位置に戻し、もう一度選んでください。</translation>
    </message>
    <message>
        <source>%1 is not homed. Press its button; with a Falcon, pull all three arms out and push them in.</source>
        <translation>%1 は原点が合っていません。本体のボタンを押してください。Falcon では3本のアームをすべて引き出してから押し込んでください。</translation>
    </message>
    <message>
        <source>The forces of %1 are off. Press its force button or move more slowly.</source>
        <translation>%1 の力が切れています。力のボタンを押すか、もっとゆっくり動かしてください。</translation>
    </message>
    <message>
        <source>%1 guarded itself against too large a force. It goes on by itself.</source>
        <translation>%1 が大きすぎる力から身を守りました。ひとりでに続きます。</translation>
    </message>
    <message>
        <source>%1 guarded itself against too fast a motion. It goes on by itself.</source>
        <translation>%1 が速すぎる動きから身を守りました。ひとりでに続きます。</translation>
    </message>
    <message>
        <source>The motors of %1 are warm. It goes on when they have cooled.</source>
        <translation>%1 のモーターが熱くなりました。冷めると続きます。</translation>
    </message>
    <message>
        <source>%1 is switched off or braked. Switch it on.</source>
        <translation>%1 の電源が切れているか、ブレーキがかかっています。入れてください。</translation>
    </message>
    <message>
        <source>%1 answers too late to be felt safely. Close other programs, or use a cable.</source>
        <translation>%1 の応答が遅く、安全に力を返せません。ほかのプログラムを閉じるか、ケーブルで接続してください。</translation>
    </message>
    <message>
        <source>The connection to %1 broke off. Check the cable.</source>
        <translation>%1 との接続が切れました。ケーブルを確かめてください。</translation>
    </message>
    <message>
        <source>%1 reports a fault. Switch it off and on again.</source>
        <translation>%1 が故障を知らせています。電源を入れ直してください。</translation>
    </message>
    <message>
        <source>The library of %1 gets no timer from the system. Close other programs.</source>
        <translation>%1 のライブラリがシステムのタイマーを使えません。ほかのプログラムを閉じてください。</translation>
    </message>
    <message>
        <source>%1 does not answer any more. Unplug it and plug it in again.</source>
        <translation>%1 が応答しなくなりました。抜いてもう一度つないでください。</translation>
    </message>
    <message>
        <source>The service of %1 has stopped. Start it again.</source>
        <translation>%1 のサービスが止まりました。もう一度起動してください。</translation>
    </message>
    <message>
        <source>What %1 sends cannot be understood. Update its service.</source>
        <translation>%1 から届くものが読み取れません。サービスを更新してください。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::DrawPanel</name>
    <message>
        <source>Draw to find</source>
        <translation>書いて探す</translation>
    </message>
    <message>
        <source>Enter takes the first, arrows choose. Ctrl+Z takes back a stroke, Delete clears, Esc closes.</source>
        <translation>Enter で先頭の字を選び、矢印キーで選び直せます。Ctrl+Z で一画取り消し、Delete で消去、Esc で閉じます。</translation>
    </message>
    <message>
        <source>Characters that look like it</source>
        <translation>似ている字</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>取り消す</translation>
    </message>
    <message>
        <source>Clear</source>
        <translation>消す</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>The drawing could not be read: %1.</source>
        <translation>書いた形を読み取れませんでした：%1。</translation>
    </message>
    <message>
        <source>Draw the character you look for. Order and direction do not matter much.</source>
        <translation>探している字を書いてください。筆順や方向はあまり気にしなくてかまいません。</translation>
    </message>
    <message>
        <source>%1 is likeliest. Enter takes it.</source>
        <translation>「%1」がいちばん似ています。Enter で選びます。</translation>
    </message>
    <message>
        <source>%1, number %2 of %3.</source>
        <translation>%1（%3 字中 %2 番目）。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::DrawingPad</name>
    <message>
        <source>Draw the character here</source>
        <translation>ここに字を書いてください</translation>
    </message>
</context>
<context>
    <name>nazori::ui::ExchangeProgress</name>
    <message>
        <source>Something is being written or read already. Wait for it, or stop it.</source>
        <translation>すでに書き出しか読み込みの途中です。終わるまで待つか、止めてください。</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>止める</translation>
    </message>
    <message>
        <source>Stopped. Everything is as it was.</source>
        <translation>止めました。すべて元のままです。</translation>
    </message>
    <message>
        <source>%1: %2. Everything is as it was.</source>
        <translation>%1：%2。すべて元のままです。</translation>
    </message>
    <message>
        <source>Writing %1…</source>
        <translation>%1 を書き出し中…</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>%1 に保存しました。</translation>
    </message>
    <message>
        <source>Reading %1…</source>
        <translation>%1 を読み込み中…</translation>
    </message>
    <message>
        <source>Imported for %1: characters %2. %1 studies now.</source>
        <translation>%1 に読み込みました。文字 %2。いまの学習者は %1 です。</translation>
    </message>
    <message>
        <source>Nothing is studied yet: there is nothing to back up.</source>
        <translation>まだ何も学習していないので、バックアップするものがありません。</translation>
    </message>
    <message>
        <source>Making a backup…</source>
        <translation>バックアップ中…</translation>
    </message>
    <message>
        <source>Backed up as %1.</source>
        <translation>%1 としてバックアップしました。</translation>
    </message>
    <message>
        <source>No backup was made: %1.</source>
        <translation>バックアップできませんでした：%1。</translation>
    </message>
    <message>
        <source>Putting the backup in place…</source>
        <translation>バックアップから元に戻しています…</translation>
    </message>
    <message>
        <source>The backup is in place. What stood there is kept.</source>
        <translation>バックアップに戻しました。前の記録は残してあります。</translation>
    </message>
    <message>
        <source>The backup was not put in place: %1. Everything is as it was.</source>
        <translation>バックアップに戻せませんでした：%1。すべて元のままです。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::FeedbackLine</name>
    <message>
        <source>What just happened</source>
        <translation>今のお知らせ</translation>
    </message>
</context>
<context>
    <name>nazori::ui::FeelPanel</name>
    <message>
        <source>at rest</source>
        <translation>待機中</translation>
    </message>
    <message>
        <source>What the stylus feels</source>
        <translation>ペン先の手ごたえ</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>今</translation>
    </message>
    <message>
        <source>Tip</source>
        <translation>ペン先</translation>
    </message>
    <message>
        <source>Buttons</source>
        <translation>ボタン</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>速さ</translation>
    </message>
    <message>
        <source>Latest</source>
        <translation>最大の遅れ</translation>
    </message>
    <message>
        <source>Missed</source>
        <translation>抜け</translation>
    </message>
    <message>
        <source>Delay</source>
        <translation>遅延</translation>
    </message>
    <message>
        <source>Feel a wall, feel a groove</source>
        <translation>壁に触れる、溝に触れる</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>材質</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>硬さ</translation>
    </message>
    <message>
        <source>Damping</source>
        <translation>粘り</translation>
    </message>
    <message>
        <source>Static friction</source>
        <translation>静止摩擦</translation>
    </message>
    <message>
        <source>Dynamic friction</source>
        <translation>動摩擦</translation>
    </message>
    <message>
        <source>Popthrough</source>
        <translation>突き抜け</translation>
    </message>
    <message>
        <source>Texture</source>
        <translation>手ざわり</translation>
    </message>
    <message>
        <source>smooth</source>
        <translation>なめらか</translation>
    </message>
    <message>
        <source>paper</source>
        <translation>紙</translation>
    </message>
    <message>
        <source>wood</source>
        <translation>木</translation>
    </message>
    <message>
        <source>stone</source>
        <translation>石</translation>
    </message>
    <message>
        <source>Roughness</source>
        <translation>粗さ</translation>
    </message>
    <message>
        <source>%1, %2, %3 mm</source>
        <translation>%1、%2、%3 mm</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>%1 times a second</source>
        <translation>毎秒 %1 回</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>At %1 % of the device&apos;s limits. On the left stands a wall, on the right lies a groove.</source>
        <translation>装置の上限の %1 % です。左に壁、右に溝があります。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::FileExchange</name>
    <message>
        <source>The character</source>
        <translation>この字</translation>
    </message>
    <message>
        <source>%1: %2. The tablet is as it was.</source>
        <translation>%1：%2。文字板は元のままです。</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>%1 に保存しました。</translation>
    </message>
    <message>
        <source>Open a height map, a stroke order, or both</source>
        <translation>高さマップ、筆順、またはその両方を開く</translation>
    </message>
    <message>
        <source>Height maps and stroke orders (*.raw *.png *.str);;All files (*)</source>
        <translation>高さマップと筆順 (*.raw *.png *.str);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>%1 is one too many: open one height map and one stroke order. The tablet is as it was.</source>
        <translation>%1 は余分です。高さマップと筆順を一つずつ開いてください。文字板は元のままです。</translation>
    </message>
    <message>
        <source>%1 is neither RAW, PNG nor .str. The tablet is as it was.</source>
        <translation>%1 は RAW、PNG、.str のどれでもありません。文字板は元のままです。</translation>
    </message>
    <message>
        <source>Size of the grid</source>
        <translation>升目の大きさ</translation>
    </message>
    <message>
        <source>%1 does not say how large its grid is.
Columns and rows:</source>
        <translation>%1 には升目の大きさが書かれていません。
一辺の升の数：</translation>
    </message>
    <message>
        <source>There is no tablet to save yet.</source>
        <translation>保存する文字板がまだありません。</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>名前を付けて保存</translation>
    </message>
</context>
<context>
    <name>nazori::ui::FunctionActions</name>
    <message>
        <source>&amp;Expression</source>
        <translation>式(&amp;E)</translation>
    </message>
    <message>
        <source>Go to the line with the expression</source>
        <translation>式の入力欄へ移ります</translation>
    </message>
    <message>
        <source>&amp;Points of interest</source>
        <translation>注目点(&amp;P)</translation>
    </message>
    <message>
        <source>Go to the table of points</source>
        <translation>注目点の表へ移ります</translation>
    </message>
    <message>
        <source>&amp;Zoom in</source>
        <translation>拡大(&amp;Z)</translation>
    </message>
    <message>
        <source>Half of the window, about the point</source>
        <translation>点を中心に範囲を半分にします</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>縮小(&amp;O)</translation>
    </message>
    <message>
        <source>Twice the window, about the point</source>
        <translation>点を中心に範囲を2倍にします</translation>
    </message>
    <message>
        <source>&amp;Whole window</source>
        <translation>はじめの範囲(&amp;W)</translation>
    </message>
    <message>
        <source>The window as it was at first</source>
        <translation>範囲をはじめに戻します</translation>
    </message>
    <message>
        <source>Save the height map as &amp;RAW…</source>
        <translation>高さマップを RAW で保存(&amp;R)…</translation>
    </message>
    <message>
        <source>8-bit height map without header, as in 2005</source>
        <translation>2005年と同じ、ヘッダーのない 8 ビットの高さマップ</translation>
    </message>
    <message>
        <source>Save the height map as P&amp;NG…</source>
        <translation>高さマップを PNG で保存(&amp;N)…</translation>
    </message>
    <message>
        <source>16-bit grey height map</source>
        <translation>16 ビット・グレースケールの高さマップ</translation>
    </message>
    <message>
        <source>Save for &amp;tactile paper…</source>
        <translation>立体コピー用に保存(&amp;T)…</translation>
    </message>
    <message>
        <source>Black and white picture with thick lines, for swell paper and for low vision</source>
        <translation>太い線の白黒画像。立体コピー用紙と弱視の方のために</translation>
    </message>
    <message>
        <source>Save the s&amp;ound…</source>
        <translation>音を保存(&amp;O)…</translation>
    </message>
    <message>
        <source>The sweep of all curves as WAV</source>
        <translation>すべての曲線の音を WAV で保存します</translation>
    </message>
    <message>
        <source>&amp;Along the curve</source>
        <translation>曲線に沿って進む(&amp;A)</translation>
    </message>
    <message>
        <source>A hundredth of the window to the right</source>
        <translation>範囲の百分の一だけ右へ</translation>
    </message>
    <message>
        <source>&amp;Back along the curve</source>
        <translation>曲線に沿って戻る(&amp;B)</translation>
    </message>
    <message>
        <source>A hundredth of the window to the left</source>
        <translation>範囲の百分の一だけ左へ</translation>
    </message>
    <message>
        <source>To the next &amp;tick</source>
        <translation>次の目盛りへ(&amp;T)</translation>
    </message>
    <message>
        <source>Along the curve to the next tick of the x axis</source>
        <translation>曲線に沿って x 軸の次の目盛りまで</translation>
    </message>
    <message>
        <source>To the tick be&amp;fore</source>
        <translation>前の目盛りへ(&amp;F)</translation>
    </message>
    <message>
        <source>Back along the curve to the tick before</source>
        <translation>曲線に沿って前の目盛りまで戻ります</translation>
    </message>
    <message>
        <source>To its &amp;start</source>
        <translation>はじめへ(&amp;S)</translation>
    </message>
    <message>
        <source>Where this piece of the curve begins</source>
        <translation>曲線のこの部分のはじまり</translation>
    </message>
    <message>
        <source>To its &amp;end</source>
        <translation>終わりへ(&amp;E)</translation>
    </message>
    <message>
        <source>Where this piece of the curve ends</source>
        <translation>曲線のこの部分の終わり</translation>
    </message>
    <message>
        <source>&amp;Next curve or branch</source>
        <translation>次の曲線・枝(&amp;N)</translation>
    </message>
    <message>
        <source>To the next curve or branch</source>
        <translation>次の曲線または枝へ</translation>
    </message>
    <message>
        <source>&amp;Previous curve or branch</source>
        <translation>前の曲線・枝(&amp;P)</translation>
    </message>
    <message>
        <source>To the curve or branch before</source>
        <translation>前の曲線または枝へ</translation>
    </message>
    <message>
        <source>Next po&amp;int</source>
        <translation>次の注目点(&amp;I)</translation>
    </message>
    <message>
        <source>To the next point of interest</source>
        <translation>次の注目点へ</translation>
    </message>
    <message>
        <source>P&amp;oint before</source>
        <translation>前の注目点(&amp;O)</translation>
    </message>
    <message>
        <source>To the point of interest before</source>
        <translation>前の注目点へ</translation>
    </message>
    <message>
        <source>Window to the &amp;left</source>
        <translation>範囲を左へ(&amp;L)</translation>
    </message>
    <message>
        <source>Show what lies to the left</source>
        <translation>左側を表示します</translation>
    </message>
    <message>
        <source>Window to the r&amp;ight</source>
        <translation>範囲を右へ(&amp;I)</translation>
    </message>
    <message>
        <source>Show what lies to the right</source>
        <translation>右側を表示します</translation>
    </message>
    <message>
        <source>Window &amp;up</source>
        <translation>範囲を上へ(&amp;U)</translation>
    </message>
    <message>
        <source>Show what lies above</source>
        <translation>上側を表示します</translation>
    </message>
    <message>
        <source>Window &amp;down</source>
        <translation>範囲を下へ(&amp;D)</translation>
    </message>
    <message>
        <source>Show what lies below</source>
        <translation>下側を表示します</translation>
    </message>
    <message>
        <source>&amp;Coordinates</source>
        <translation>座標(&amp;C)</translation>
    </message>
    <message>
        <source>Say where the point is</source>
        <translation>点の位置を伝えます</translation>
    </message>
    <message>
        <source>S&amp;lope</source>
        <translation>傾き(&amp;L)</translation>
    </message>
    <message>
        <source>Say how steep the curve is here</source>
        <translation>ここでの曲線の傾きを伝えます</translation>
    </message>
    <message>
        <source>Su&amp;mmary</source>
        <translation>要約(&amp;M)</translation>
    </message>
    <message>
        <source>Say in one sentence what is drawn</source>
        <translation>描かれているものを一文で伝えます</translation>
    </message>
    <message>
        <source>&amp;Drop a beacon</source>
        <translation>目印を置く(&amp;D)</translation>
    </message>
    <message>
        <source>Remember this place</source>
        <translation>この場所を覚えます</translation>
    </message>
    <message>
        <source>&amp;Go to the next beacon</source>
        <translation>次の目印へ(&amp;G)</translation>
    </message>
    <message>
        <source>To the next of the places remembered</source>
        <translation>覚えた場所の次へ</translation>
    </message>
    <message>
        <source>Next piece alone</source>
        <translation>次の曲線だけ</translation>
    </message>
    <message>
        <source>Hold the stylus to the next piece alone</source>
        <translation>次の曲線だけがペンを引き寄せます</translation>
    </message>
    <message>
        <source>Piece before alone</source>
        <translation>前の曲線だけ</translation>
    </message>
    <message>
        <source>Hold the stylus to the piece before alone</source>
        <translation>前の曲線だけがペンを引き寄せます</translation>
    </message>
    <message>
        <source>All pieces</source>
        <translation>すべての曲線</translation>
    </message>
    <message>
        <source>Hold the stylus to any piece</source>
        <translation>どの曲線もペンを引き寄せます</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>吸着</translation>
    </message>
    <message>
        <source>Curves hold the stylus</source>
        <translation>曲線がペンを引き寄せます</translation>
    </message>
    <message>
        <source>Clear the ink</source>
        <translation>墨を消す</translation>
    </message>
    <message>
        <source>Wipe the tablet clean</source>
        <translation>板の墨をふき取ります</translation>
    </message>
    <message>
        <source>&amp;Hear the curves</source>
        <translation>曲線を聴く(&amp;H)</translation>
    </message>
    <message>
        <source>Play every curve from end to end</source>
        <translation>すべての曲線を端から端まで鳴らします</translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation>止める(&amp;S)</translation>
    </message>
    <message>
        <source>Stop every sound, and the drawing</source>
        <translation>すべての音と描画を止めます</translation>
    </message>
    <message>
        <source>&amp;Faster</source>
        <translation>速く(&amp;F)</translation>
    </message>
    <message>
        <source>Play the curves faster</source>
        <translation>曲線を速く鳴らします</translation>
    </message>
    <message>
        <source>S&amp;lower</source>
        <translation>遅く(&amp;L)</translation>
    </message>
    <message>
        <source>Play the curves slower</source>
        <translation>曲線を遅く鳴らします</translation>
    </message>
    <message>
        <source>L&amp;ouder</source>
        <translation>大きく(&amp;O)</translation>
    </message>
    <message>
        <source>More volume</source>
        <translation>音量を上げます</translation>
    </message>
    <message>
        <source>&amp;Quieter</source>
        <translation>小さく(&amp;Q)</translation>
    </message>
    <message>
        <source>Less volume</source>
        <translation>音量を下げます</translation>
    </message>
    <message>
        <source>&amp;Mute</source>
        <translation>消音(&amp;M)</translation>
    </message>
    <message>
        <source>No sound at all</source>
        <translation>音を出しません</translation>
    </message>
    <message>
        <source>&amp;Plot</source>
        <translation>グラフ(&amp;P)</translation>
    </message>
    <message>
        <source>T&amp;race</source>
        <translation>たどる(&amp;R)</translation>
    </message>
    <message>
        <source>S&amp;ound</source>
        <translation>音(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Only this curve</source>
        <translation>この曲線だけ(&amp;O)</translation>
    </message>
    <message>
        <source>Carve and play one curve without the others</source>
        <translation>ほかの曲線を除いて一本だけを彫り、鳴らします</translation>
    </message>
    <message>
        <source>Next cur&amp;ve alone</source>
        <translation>次の曲線だけ(&amp;V)</translation>
    </message>
    <message>
        <source>Carve and play the next curve without the others, after the last one all</source>
        <translation>次の曲線だけを彫り、鳴らします。最後の次はすべてです</translation>
    </message>
    <message>
        <source>&amp;Tone of y = 0</source>
        <translation>y = 0 の音(&amp;T)</translation>
    </message>
    <message>
        <source>Play the tone of y = 0, to compare with</source>
        <translation>比べるための y = 0 の音を鳴らします</translation>
    </message>
</context>
<context>
    <name>nazori::ui::FunctionsWorkplace</name>
    <message>
        <source>F&amp;unctions</source>
        <translation>関数(&amp;U)</translation>
    </message>
    <message>
        <source>Curves to see, feel and hear</source>
        <translation>見て、触れて、聴く曲線</translation>
    </message>
    <message>
        <source>&amp;Expression and window</source>
        <translation>式と範囲(&amp;E)</translation>
    </message>
    <message>
        <source>Show or fold away the expression</source>
        <translation>式の欄を表示または折りたたみます</translation>
    </message>
    <message>
        <source>&amp;Points of interest</source>
        <translation>注目点(&amp;P)</translation>
    </message>
    <message>
        <source>Show or fold away the points of interest</source>
        <translation>注目点を表示または折りたたみます</translation>
    </message>
    <message>
        <source>The plot as grooves. Left and right go along the curve, up and down to another, Tab to the next point of interest, H plays it, S says what it is; Control L leaves to the expression, Control T to the table</source>
        <translation>溝として彫られたグラフ。左右キーで曲線に沿って動き、上下キーで別の曲線へ、Tab で次の注目点へ移ります。H で音を鳴らし、S で要約を伝えます。Ctrl+L で式へ、Ctrl+T で表へ移ります</translation>
    </message>
    <message>
        <source>This window cannot be shown: %1.</source>
        <translation>この範囲は表示できません: %1。</translation>
    </message>
    <message>
        <source>“%1” is no number. The window is as it was.</source>
        <translation>「%1」は数ではありません。範囲は変わっていません。</translation>
    </message>
    <message>
        <source>Curves hold the stylus.</source>
        <translation>曲線がペンを引き寄せます。</translation>
    </message>
    <message>
        <source>Curves let the stylus go.</source>
        <translation>曲線はペンを放します。</translation>
    </message>
    <message>
        <source>The drawing was stopped. What is shown need not be all of it.</source>
        <translation>描画を止めました。見えているものが全部とは限りません。</translation>
    </message>
    <message>
        <source>The curve is still being drawn.</source>
        <translation>曲線を描いているところです。</translation>
    </message>
    <message>
        <source>Nothing can be heard on this computer.</source>
        <translation>このコンピューターでは音を出せません。</translation>
    </message>
    <message>
        <source>Volume %1</source>
        <translation>音量 %1</translation>
    </message>
    <message>
        <source>This cannot be drawn: %1. The plate is as it was.</source>
        <translation>これは描けません: %1。板は変わっていません。</translation>
    </message>
    <message>
        <source>%1 is saved.</source>
        <translation>%1 を保存しました。</translation>
    </message>
    <message>
        <source>%1 was not saved: %2.</source>
        <translation>%1 を保存できませんでした: %2。</translation>
    </message>
    <message>
        <source>A surface has no curve to play.</source>
        <translation>曲面には鳴らす曲線がありません。</translation>
    </message>
    <message>
        <source>The sound is off. M turns it on.</source>
        <translation>音は切れています。M で入ります。</translation>
    </message>
    <message>
        <source>The sound is off.</source>
        <translation>音を切りました。</translation>
    </message>
    <message>
        <source>The sound is on.</source>
        <translation>音を入れました。</translation>
    </message>
    <message>
        <source>%1 was not opened: %2. The plate is as it was.</source>
        <translation>%1 を開けませんでした: %2。板は変わっていません。</translation>
    </message>
    <message>
        <source>%1 is on the desk.</source>
        <translation>%1 を開きました。</translation>
    </message>
    <message>
        <source>Open a plot</source>
        <translation>グラフを開く</translation>
    </message>
    <message>
        <source>There is no plot to save yet.</source>
        <translation>保存するグラフがまだありません。</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>名前を付けて保存</translation>
    </message>
    <message>
        <source>plot</source>
        <translation>グラフ</translation>
    </message>
    <message>
        <source>“%1” is no range of heights. The range is as it was.</source>
        <translation>「%1」は高さの範囲ではありません。範囲は前のままです。</translation>
    </message>
    <message>
        <source>y = 0 lies outside the window.</source>
        <translation>y = 0 は範囲の外です。</translation>
    </message>
    <message>
        <source>This is the tone of y = 0.</source>
        <translation>これが y = 0 の音です。</translation>
    </message>
    <message>
        <source>A surface has no lines to print.</source>
        <translation>曲面には印刷する線がありません。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::HardStrokesCard</name>
    <message>
        <source>Stroke %1 of %2 went wrong in %3 of %4 writings: %5</source>
        <translation>「%2」の%1画目：%4回のうち%3回まちがい。%5</translation>
    </message>
    <message>
        <source>Hardest strokes</source>
        <translation>苦手な画</translation>
    </message>
    <message>
        <source>No stroke has gone wrong twice. Those that do will stand here.</source>
        <translation>二度まちがえた画はありません。あればここに並びます。</translation>
    </message>
    <message>
        <source>Strokes that went wrong more than once: %1. Enter opens the character.</source>
        <translation>二度以上まちがえた画：%1。Enter で文字を開きます。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::Home</name>
    <message>
        <source>H&amp;ome</source>
        <translation>ホーム(&amp;O)</translation>
    </message>
    <message>
        <source>What is due today, and how to begin</source>
        <translation>今日の学習と、その始め方</translation>
    </message>
    <message>
        <source>Enter starts. Everything is kept as soon as it is rated.</source>
        <translation>Enter で始まります。評価したものはすぐに保存されます。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::HomeActions</name>
    <message>
        <source>&amp;Study what is due</source>
        <translation>今日の分を学習する(&amp;S)</translation>
    </message>
    <message>
        <source>Begin with what is due now</source>
        <translation>今の分から始めます</translation>
    </message>
    <message>
        <source>&amp;Another lesson for what is forgotten often</source>
        <translation>よく忘れる文字の別の練習(&amp;A)</translation>
    </message>
    <message>
        <source>Characters that were set apart, from watching on</source>
        <translation>取り分けた文字を、見るところからやり直します</translation>
    </message>
    <message>
        <source>&amp;Take back the last review</source>
        <translation>最後の復習を取り消す(&amp;T)</translation>
    </message>
    <message>
        <source>Take back what was kept last; again for the one before, also of other days</source>
        <translation>最後に保存したものを取り消します。繰り返すと、その前のものや別の日のものも取り消せます</translation>
    </message>
    <message>
        <source>Study se&amp;ttings…</source>
        <translation>学習の設定(&amp;T)…</translation>
    </message>
    <message>
        <source>Limits, lists, order, desired retention</source>
        <translation>一日の量、リスト、順番、目標の定着率</translation>
    </message>
    <message>
        <source>St&amp;udy</source>
        <translation>学習(&amp;U)</translation>
    </message>
</context>
<context>
    <name>nazori::ui::HomePage</name>
    <message>
        <source>Today</source>
        <translation>今日</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>もう一度試す</translation>
    </message>
    <message>
        <source>Another lesson for these</source>
        <translation>これらの文字の別の練習</translation>
    </message>
    <message>
        <source>Study settings…</source>
        <translation>学習の設定…</translation>
    </message>
    <message>
        <source>Choose a character</source>
        <translation>文字を選ぶ</translation>
    </message>
    <message numerus="yes">
        <source>Done for now. %n characters come once more, the first at %1.</source>
        <translation>
            <numerusform>今のところ終わりです。あと %n 字がもう一度出ます。最初は %1 です。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Done for today: your limit is reached. %n reviews wait for tomorrow.</source>
        <translation>
            <numerusform>今日は終わりです。一日の上限に達しました。%n 件の復習は明日にまわります。</numerusform>
        </translation>
    </message>
    <message>
        <source>There is nothing to learn yet. Choose lists and new characters a day in the study settings.</source>
        <translation>まだ学ぶものがありません。学習の設定でリストと一日の新しい文字の数を選んでください。</translation>
    </message>
    <message numerus="yes">
        <source>Done for today. Tomorrow %n reviews are due.</source>
        <translation>
            <numerusform>今日は終わりです。明日は %n 件の復習があります。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n reviews have piled up. No hurry: today %1, what is best known first, so that most is kept.</source>
        <translation>
            <numerusform>復習が %n 件たまっています。急ぐことはありません。今日は %1 件、よく覚えているものからです。そのほうが多く残ります。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Catching up takes %n days; the last is %1. Until then nothing new is added.</source>
        <translation>
            <numerusform>%n 日かかり、%1に追いつきます。それまで新しい文字は加わりません。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more reviews wait for another day: that is your limit.</source>
        <translation>
            <numerusform>あと %n 件の復習は別の日にまわります。一日の上限です。</numerusform>
        </translation>
    </message>
    <message>
        <source>Each new character is first watched, then traced, then written with help that fades, then from memory. It comes back just before it would be forgotten.</source>
        <translation>新しい文字は、まず見て、次になぞり、だんだん減る助けとともに書き、それから覚えて書きます。忘れそうになる少し前にまた出てきます。</translation>
    </message>
    <message>
        <source>New today: %1</source>
        <translation>今日の新しい文字：%1</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <translation>%1 · %2</translation>
    </message>
    <message>
        <source>due now</source>
        <translation>件の復習</translation>
    </message>
    <message>
        <source>new, after %1 today</source>
        <translation>字が新しい文字（今日すでに %1 字）</translation>
    </message>
    <message>
        <source>new today</source>
        <translation>字が新しい文字</translation>
    </message>
    <message numerus="yes">
        <source>minutes, about</source>
        <translation>
            <numerusform>分ほど</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>days in a row</source>
        <translation>
            <numerusform>日続けて</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>days in a row; this week&apos;s day off is used</source>
        <translation>
            <numerusform>日続けて（今週の休みは使いました）</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>days in a row; one day off a week is forgiven</source>
        <translation>
            <numerusform>日続けて（週に一日は休んでも続きます）</numerusform>
        </translation>
    </message>
    <message>
        <source>Go on with the session</source>
        <translation>学習を続ける</translation>
    </message>
    <message>
        <source>Enter or the space bar starts</source>
        <translation>Enter またはスペースキーで始まります</translation>
    </message>
    <message numerus="yes">
        <source>%n characters are forgotten often and set apart: %1</source>
        <translation>
            <numerusform>よく忘れるため取り分けた文字が %n 字あります：%1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Done: %n written from memory.</source>
        <translation>
            <numerusform>覚えて書いたもの：%n 件</numerusform>
        </translation>
    </message>
    <message>
        <source>Met first: %1</source>
        <translation>初めての文字：%1</translation>
    </message>
    <message>
        <source>Had another lesson: %1</source>
        <translation>別の練習をした文字：%1</translation>
    </message>
    <message>
        <source>To see again soon: %1</source>
        <translation>まもなくもう一度：%1</translation>
    </message>
    <message>
        <source>Time: %1</source>
        <translation>時間：%1</translation>
    </message>
    <message numerus="yes">
        <source>Start: %n characters, %1</source>
        <translation>
            <numerusform>始める：%n 字、%1</numerusform>
        </translation>
    </message>
    <message>
        <source>Done for today. Tomorrow new characters come, and no reviews.</source>
        <translation>今日は終わりです。明日は新しい文字だけで、復習はありません。</translation>
    </message>
    <message>
        <source>Done for today. Nothing is due tomorrow.</source>
        <translation>今日は終わりです。明日の分はありません。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::InformationPanel</name>
    <message>
        <source>About the character</source>
        <translation>字の情報</translation>
    </message>
    <message>
        <source>On reading</source>
        <translation>音読み</translation>
    </message>
    <message>
        <source>Kun reading</source>
        <translation>訓読み</translation>
    </message>
    <message>
        <source>Radical</source>
        <translation>部首</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>構成要素</translation>
    </message>
    <message>
        <source>Words</source>
        <translation>熟語・ことば</translation>
    </message>
    <message>
        <source>Your own tablet</source>
        <translation>自分の文字板</translation>
    </message>
    <message>
        <source>%1 × %1 samples</source>
        <translation>%1 × %1 点</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes</source>
        <translation>
            <numerusform>%n 画</numerusform>
        </translation>
    </message>
    <message>
        <source>Hiragana</source>
        <translation>ひらがな</translation>
    </message>
    <message>
        <source>Katakana</source>
        <translation>カタカナ</translation>
    </message>
    <message>
        <source>Letter or digit</source>
        <translation>英字・数字</translation>
    </message>
    <message>
        <source>No meaning is recorded</source>
        <translation>意味の記載はありません</translation>
    </message>
    <message>
        <source>%1 here, %2 in the dictionary</source>
        <translation>ここでは%1、辞書では %2 画</translation>
    </message>
    <message>
        <source>grade %1</source>
        <translation>小学%1年</translation>
    </message>
    <message>
        <source>secondary school</source>
        <translation>中学以上</translation>
    </message>
    <message>
        <source>for names</source>
        <translation>人名用</translation>
    </message>
    <message>
        <source>old JLPT %1</source>
        <translation>旧日本語能力試験 %1 級</translation>
    </message>
    <message>
        <source>The kanji stands for %1; %2 follows it in kana</source>
        <translation>漢字が「%1」に当たり、「%2」を送ります</translation>
    </message>
    <message>
        <source>, a form of %1</source>
        <translation>（%1の形）</translation>
    </message>
    <message>
        <source>%1. Go there</source>
        <translation>%1&#x3000;この字へ</translation>
    </message>
    <message>
        <source>no. %1 in newspapers</source>
        <translation>新聞での頻度 %1 位</translation>
    </message>
</context>
<context>
    <name>nazori::ui::InkGallery</name>
    <message>
        <source>Earlier writing beside today&apos;s</source>
        <translation>前に書いたものと今日のもの</translation>
    </message>
</context>
<context>
    <name>nazori::ui::KeyListDialog</name>
    <message>
        <source>Keys and mouse</source>
        <translation>キーとマウス</translation>
    </message>
    <message>
        <source>On the tablet</source>
        <translation>文字板の上で</translation>
    </message>
    <message>
        <source>Stylus down</source>
        <translation>ペン先を下ろす</translation>
    </message>
    <message>
        <source>left button, pen tip</source>
        <translation>左ボタン、ペン先</translation>
    </message>
    <message>
        <source>Deeper, less deep</source>
        <translation>深く／浅く</translation>
    </message>
    <message>
        <source>wheel while pressed, pen pressure</source>
        <translation>押したままホイール、筆圧</translation>
    </message>
    <message>
        <source>Turn and tilt</source>
        <translation>回す・傾ける</translation>
    </message>
    <message>
        <source>right button, pen&apos;s side button</source>
        <translation>右ボタン、ペンのボタン</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>動かす</translation>
    </message>
    <message>
        <source>middle button, or right with Shift</source>
        <translation>中ボタン、または Shift＋右ボタン</translation>
    </message>
    <message>
        <source>Nearer, farther</source>
        <translation>近づく／遠ざかる</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>ホイール</translation>
    </message>
    <message>
        <source>Straight view</source>
        <translation>正面に戻す</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Home</translation>
    </message>
    <message>
        <source>Take back a stroke (Memory)</source>
        <translation>一画取り消す（覚えて書く）</translation>
    </message>
    <message>
        <source>pen&apos;s other end</source>
        <translation>ペンの反対側</translation>
    </message>
</context>
<context>
    <name>nazori::ui::LearnerActions</name>
    <message>
        <source>&amp;Who studies…</source>
        <translation>学習者(&amp;W)…</translation>
    </message>
    <message>
        <source>Choose, add, rename or remove a learner</source>
        <translation>学習者を選ぶ、加える、名前を変える、外す</translation>
    </message>
    <message>
        <source>&amp;Back up now</source>
        <translation>今すぐバックアップ(&amp;B)</translation>
    </message>
    <message>
        <source>Keep a copy of everything besides the daily ones</source>
        <translation>毎日のもののほかに、すべての控えを残す</translation>
    </message>
    <message>
        <source>&amp;Restore from a backup…</source>
        <translation>バックアップから戻す(&amp;R)…</translation>
    </message>
    <message>
        <source>See the backups and put one in place</source>
        <translation>バックアップを見て、一つに戻す</translation>
    </message>
    <message>
        <source>&amp;Export everything…</source>
        <translation>すべて書き出す(&amp;E)…</translation>
    </message>
    <message>
        <source>Write the whole log with its ink, lists and tags to a file (JSON)</source>
        <translation>記録、筆跡、リスト、タグをすべてファイルに書く (JSON)</translation>
    </message>
    <message>
        <source>Export a &amp;table of reviews…</source>
        <translation>復習の表を書き出す(&amp;T)…</translation>
    </message>
    <message>
        <source>Write every writing to a table (CSV)</source>
        <translation>書いたものをすべて表にする (CSV)</translation>
    </message>
    <message>
        <source>Export for &amp;Anki…</source>
        <translation>Anki 用に書き出す(&amp;A)…</translation>
    </message>
    <message>
        <source>Write cards with stroke order, readings, meanings and words (.apkg)</source>
        <translation>筆順、読み、意味、語のカードを書き出す (.apkg)</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>読み込む(&amp;I)…</translation>
    </message>
    <message>
        <source>Read what was exported (JSON), also elsewhere</source>
        <translation>書き出したもの（ほかのパソコンのものも）を読み込む (JSON)</translation>
    </message>
    <message>
        <source>&amp;Learner</source>
        <translation>学習者(&amp;L)</translation>
    </message>
</context>
<context>
    <name>nazori::ui::LearnerMenu</name>
    <message>
        <source>Everything of a learner (*.json)</source>
        <translation>学習者のすべて (*.json)</translation>
    </message>
    <message>
        <source>Tables (*.csv)</source>
        <translation>表 (*.csv)</translation>
    </message>
    <message>
        <source>Anki packages (*.apkg)</source>
        <translation>Anki パッケージ (*.apkg)</translation>
    </message>
    <message>
        <source>Nothing is studied yet: there is nothing to export.</source>
        <translation>まだ何も学習していないので、書き出すものがありません。</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>書き出す</translation>
    </message>
    <message>
        <source>Import</source>
        <translation>読み込む</translation>
    </message>
    <message>
        <source>Everything of a learner (*.json);;All files (*)</source>
        <translation>学習者のすべて (*.json);;すべてのファイル (*)</translation>
    </message>
</context>
<context>
    <name>nazori::ui::LearnerWords</name>
    <message>
        <source>The study data cannot be read: %1.</source>
        <translation>学習データを読めません：%1。</translation>
    </message>
    <message>
        <source>“%1” cannot be the name of a learner: up to 60 bytes, no “/”, and no dot at its beginning.</source>
        <translation>「%1」は学習者の名前にできません。60 バイトまでで、「/」を含まず、点で始まらないものにしてください。</translation>
    </message>
    <message>
        <source>No folder for learners is known: set NAZORI_LEARNERS. Nothing is kept.</source>
        <translation>学習者のフォルダーが分かりません。NAZORI_LEARNERS を設定してください。何も保存されません。</translation>
    </message>
    <message>
        <source>Today&apos;s backup could not be made: %1. Studying works.</source>
        <translation>今日のバックアップを作れませんでした：%1。学習はできます。</translation>
    </message>
    <message>
        <source>The store of %1 was written by a newer Nazori or another program: %2. Nothing was changed, and nothing is kept.</source>
        <translation>%1 の記録は新しい版の Nazori か別のプログラムのものです：%2。何も変えていません。何も保存されません。</translation>
    </message>
    <message>
        <source>The store of %1 is damaged: %2. Nothing was changed. A backup can be put in its place.</source>
        <translation>%1 の記録が壊れています：%2。何も変えていません。バックアップから戻せます。</translation>
    </message>
    <message>
        <source>The store of %1 cannot be written: %2. Nothing is kept.</source>
        <translation>%1 の記録に書き込めません：%2。何も保存されません。</translation>
    </message>
    <message>
        <source>It could not be kept: %1.</source>
        <translation>保存できませんでした：%1。</translation>
    </message>
    <message>
        <source>“%1” is open here now: everything is kept.</source>
        <translation>「%1」をここで開きました。すべて保存されます。</translation>
    </message>
    <message>
        <source>“%1” is open in another window of Nazori. Close it there; until then nothing is kept here.</source>
        <translation>「%1」は別の Nazori の窓で開いています。そちらを閉じてください。それまでここでは何も保存されません。</translation>
    </message>
    <message>
        <source>the disk is full. Make room; what was kept before is safe</source>
        <translation>ディスクがいっぱいです。空きを作ってください。前に保存したものは無事です</translation>
    </message>
    <message>
        <source>%1 may not be written. Check the permissions of the folder</source>
        <translation>%1 に書き込めません。フォルダーの権限を確かめてください</translation>
    </message>
    <message>
        <source>Every character of %1 is being worked out anew. Nothing is kept until that is done.</source>
        <translation>%1 のすべての漢字を計算し直しています。終わるまで、書いたものは保存されません。</translation>
    </message>
    <message>
        <source>Something is being put in the place of what %1 has done. Nothing is kept until it is there.</source>
        <translation>%1 の記録を置き換えています。終わるまで、書いたものは保存されません。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::LearnersDialog</name>
    <message>
        <source>Who studies</source>
        <translation>学習者</translation>
    </message>
    <message>
        <source>&amp;Learners</source>
        <translation>学習者(&amp;L)</translation>
    </message>
    <message>
        <source>Learners</source>
        <translation>学習者</translation>
    </message>
    <message>
        <source>&amp;Name, to add or rename</source>
        <translation>名前（加える・変える）(&amp;N)</translation>
    </message>
    <message>
        <source>Name, to add or rename</source>
        <translation>名前（加える・変える）</translation>
    </message>
    <message>
        <source>&amp;Study as this learner</source>
        <translation>この学習者で学ぶ(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>加える(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>名前を変える(&amp;R)</translation>
    </message>
    <message>
        <source>Re&amp;move…</source>
        <translation>外す(&amp;M)…</translation>
    </message>
    <message>
        <source>Everyone has their own log, settings and backups.</source>
        <translation>記録、設定、バックアップは学習者ごとにあります。</translation>
    </message>
    <message>
        <source>✓ %1 (studies now)</source>
        <translation>✓ %1（学習中）</translation>
    </message>
    <message>
        <source>Type a name first: up to 60 bytes, no “/”, and no dot at its beginning.</source>
        <translation>まず名前を入力してください。60 バイトまで、「/」なし、先頭の点なし。</translation>
    </message>
    <message>
        <source>%1 is there already. Type another name.</source>
        <translation>%1 はもうあります。ほかの名前にしてください。</translation>
    </message>
    <message>
        <source>%1 studies now.</source>
        <translation>いまの学習者は %1 です。</translation>
    </message>
    <message>
        <source>%1 keeps its name: %2.</source>
        <translation>%1 の名前は変わりません：%2。</translation>
    </message>
    <message>
        <source>%1 is called %2 now.</source>
        <translation>%1 の名前は %2 になりました。</translation>
    </message>
    <message>
        <source>Remove a learner</source>
        <translation>学習者を外す</translation>
    </message>
    <message>
        <source>Remove %1 with all reviews, ink and backups from the list of learners?</source>
        <translation>%1 を、復習、筆跡、バックアップとともに学習者の一覧から外しますか。</translation>
    </message>
    <message>
        <source>Nothing is deleted: the folder is moved to “.removed” beside the other learners, and moved back it is there again.</source>
        <translation>何も消えません。フォルダーはほかの学習者の隣の「.removed」に移り、戻せばまた使えます。</translation>
    </message>
    <message>
        <source>Re&amp;move</source>
        <translation>外す(&amp;M)</translation>
    </message>
    <message>
        <source>%1 is removed. The folder lies in %2.</source>
        <translation>%1 を外しました。フォルダーは %2 にあります。</translation>
    </message>
    <message>
        <source>%1 could not be removed: %2.</source>
        <translation>%1 を外せませんでした：%2。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::LibraryPanel</name>
    <message>
        <source>Characters</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>休, yasumu, rest …</source>
        <translation>休、yasumu、rest …</translation>
    </message>
    <message>
        <source>Find a character</source>
        <translation>文字を探す</translation>
    </message>
    <message>
        <source>Find a character by itself, by a reading in kana or romaji, or by an English meaning (Ctrl+F)</source>
        <translation>字そのもの、かな・ローマ字の読み、英語の意味で探せます (Ctrl+F)</translation>
    </message>
    <message>
        <source>Grade 1</source>
        <translation>小学1年</translation>
    </message>
    <message>
        <source>Grade 2</source>
        <translation>小学2年</translation>
    </message>
    <message>
        <source>Grade 3</source>
        <translation>小学3年</translation>
    </message>
    <message>
        <source>Grade 4</source>
        <translation>小学4年</translation>
    </message>
    <message>
        <source>Grade 5</source>
        <translation>小学5年</translation>
    </message>
    <message>
        <source>Grade 6</source>
        <translation>小学6年</translation>
    </message>
    <message>
        <source>Secondary school</source>
        <translation>中学以上（常用）</translation>
    </message>
    <message>
        <source>For names</source>
        <translation>人名用</translation>
    </message>
    <message>
        <source>Hiragana</source>
        <translation>ひらがな</translation>
    </message>
    <message>
        <source>Katakana</source>
        <translation>カタカナ</translation>
    </message>
    <message>
        <source>Letters and digits</source>
        <translation>英字・数字</translation>
    </message>
    <message>
        <source>All characters</source>
        <translation>すべての字</translation>
    </message>
    <message>
        <source>List of characters</source>
        <translation>文字の一覧</translation>
    </message>
    <message>
        <source>Characters of the list</source>
        <translation>一覧の字</translation>
    </message>
    <message numerus="yes">
        <source>%n found</source>
        <translation>
            <numerusform>%n 件</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters</source>
        <translation>
            <numerusform>%n 字</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing found for “%1”. Try a character (休), a reading (やすむ, yasumu) or the beginning of an English meaning (rest).</source>
        <translation>「%1」は見つかりませんでした。字（休）、読み（やすむ、yasumu）、英語の意味の初め（rest）を試してください。</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>検索結果</translation>
    </message>
</context>
<context>
    <name>nazori::ui::ListChoice</name>
    <message>
        <source>Your lists and tags cannot be read: %1</source>
        <translation>自分のリストとタグを読めません：%1</translation>
    </message>
    <message>
        <source>Met so far</source>
        <translation>これまでに学んだ文字</translation>
    </message>
    <message>
        <source>School grade %1</source>
        <translation>小学%1年</translation>
    </message>
    <message>
        <source>Secondary school</source>
        <translation>中学以上（常用）</translation>
    </message>
    <message>
        <source>For names</source>
        <translation>人名用</translation>
    </message>
    <message>
        <source>Hiragana</source>
        <translation>ひらがな</translation>
    </message>
    <message>
        <source>Katakana</source>
        <translation>カタカナ</translation>
    </message>
    <message>
        <source>Old JLPT level %1 (before 2010)</source>
        <translation>旧日本語能力試験 %1 級（2010年より前）</translation>
    </message>
    <message>
        <source>Own list: %1</source>
        <translation>自分のリスト：%1</translation>
    </message>
    <message>
        <source>Tag: %1</source>
        <translation>タグ：%1</translation>
    </message>
</context>
<context>
    <name>nazori::ui::MainWindow</name>
    <message>
        <source>The recording has ended. Writing %1.</source>
        <translation>記録を終えました。%1 を書き出しています。</translation>
    </message>
    <message>
        <source>The tablet cannot be drawn here: OpenGL 3.3 is missing. The package libgl1-mesa-dri draws it on any computer. Lists and information work.</source>
        <translation>OpenGL 3.3 がないため、ここでは文字板を描けません。libgl1-mesa-dri パッケージがあればどの計算機でも描けます。一覧と字の情報は使えます。</translation>
    </message>
    <message>
        <source>Carved tablet</source>
        <translation>彫られた文字板</translation>
    </message>
    <message>
        <source>The settings could not be saved in %1. They hold until Nazori is closed.</source>
        <translation>設定を %1 に保存できませんでした。Nazori を閉じるまでは有効です。</translation>
    </message>
    <message>
        <source>The kanji database: %1.</source>
        <translation>漢字データベース：%1。</translation>
    </message>
    <message>
        <source>The tablet cannot be drawn: %1.</source>
        <translation>文字板を描けません：%1。</translation>
    </message>
    <message>
        <source>The stylus does not work: %1.</source>
        <translation>ペン先が動きません：%1。</translation>
    </message>
    <message>
        <source>%1 – Nazori</source>
        <translation>%1 – Nazori</translation>
    </message>
    <message>
        <source>Another device: the recording goes on in %1.</source>
        <translation>装置が替わったので、記録は %1 に続きます。</translation>
    </message>
    <message>
        <source>The recording %1 has ended: %2.</source>
        <translation>記録 %1 は終わりました：%2。</translation>
    </message>
    <message>
        <source>A recording had broken off. It is complete now: %1.</source>
        <translation>途切れていた記録を最後まで復元しました：%1。</translation>
    </message>
    <message>
        <source>A recording had broken off with the computer. It may lack its last second: %1.</source>
        <translation>計算機とともに途切れた記録があります。最後の一秒が欠けているかもしれません：%1。</translation>
    </message>
    <message>
        <source>Loudness %1 %.</source>
        <translation>音の大きさ %1 %。</translation>
    </message>
    <message>
        <source>Recorded: %1.</source>
        <translation>記録しました：%1。</translation>
    </message>
    <message>
        <source>The recording is not whole: %1.</source>
        <translation>記録は完全ではありません：%1。</translation>
    </message>
    <message>
        <source>Record the session</source>
        <translation>記録する</translation>
    </message>
    <message>
        <source>Recording, to be replayed (*.nzr)</source>
        <translation>再生できる記録 (*.nzr)</translation>
    </message>
    <message>
        <source>Table (*.csv)</source>
        <translation>表 (*.csv)</translation>
    </message>
    <message>
        <source>%1: %2. Nothing is recorded.</source>
        <translation>%1：%2。記録していません。</translation>
    </message>
    <message>
        <source>Recording to %1 until %2 is pressed again.</source>
        <translation>もう一度 %2 を押すまで %1 に記録します。</translation>
    </message>
    <message>
        <source>Your writing of %1 is not rated yet.</source>
        <translation>%1 の評価がまだです。</translation>
    </message>
    <message>
        <source>Without a rating it is not saved.</source>
        <translation>評価しないと保存されません。</translation>
    </message>
    <message>
        <source>Rate as “%1” and quit</source>
        <translation>「%1」と評価して終了</translation>
    </message>
    <message>
        <source>Rate as “%1” and go on</source>
        <translation>「%1」と評価して続ける</translation>
    </message>
    <message>
        <source>Quit without rating</source>
        <translation>評価せずに終了</translation>
    </message>
    <message>
        <source>Go on without rating</source>
        <translation>評価せずに続ける</translation>
    </message>
    <message>
        <source>Go back</source>
        <translation>戻る</translation>
    </message>
</context>
<context>
    <name>nazori::ui::MemoryPage</name>
    <message>
        <source>Your writing is judged %1.</source>
        <translation>%1採点します。</translation>
    </message>
    <message>
        <source>Your writing beside the model. Space replays both.</source>
        <translation>書いた字と手本を並べました。スペースキーで両方を再生します。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::NewListDialog</name>
    <message>
        <source>New list</source>
        <translation>新しいリスト</translation>
    </message>
    <message>
        <source>Characters</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>休日月火水木金土
# what follows such a sign is a note</source>
        <translation>休日月火水木金土
# この印の後はメモです</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>ファイルから…</translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation>名前(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Characters</source>
        <translation>文字(&amp;C)</translation>
    </message>
    <message>
        <source>Read a list</source>
        <translation>リストを読む</translation>
    </message>
    <message>
        <source>Texts (*.txt *.csv *.tsv);;All files (*)</source>
        <translation>テキスト (*.txt *.csv *.tsv);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Give the list a name of at most 100 bytes.</source>
        <translation>リストに 100 バイトまでの名前を付けてください。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::Numbers</name>
    <message>
        <source>%1 %2</source>
        <comment>head of a column, its number</comment>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>a row of a table, its numbers</comment>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>nazori::ui::PlotPanel</name>
    <message>
        <source>&amp;Axes</source>
        <translation>軸(&amp;A)</translation>
    </message>
    <message>
        <source>Tic&amp;ks</source>
        <translation>目盛り(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Grid</source>
        <translation>格子(&amp;G)</translation>
    </message>
    <message>
        <source>Ri&amp;m</source>
        <translation>縁(&amp;M)</translation>
    </message>
    <message>
        <source>No soun&amp;d</source>
        <translation>音なし(&amp;D)</translation>
    </message>
    <message>
        <source>Expression and window</source>
        <translation>式と範囲</translation>
    </message>
    <message>
        <source>Expression</source>
        <translation>式</translation>
    </message>
    <message>
        <source>Several are separated by semicolons. Up and down: what was entered before</source>
        <translation>複数の式はセミコロンで区切ります。上下キーで以前の式を呼び出します</translation>
    </message>
    <message>
        <source>The expression in words</source>
        <translation>言葉にした式</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>描画</translation>
    </message>
    <message>
        <source>Examples</source>
        <translation>例</translation>
    </message>
    <message>
        <source>Examples…</source>
        <translation>例を選ぶ</translation>
    </message>
    <message>
        <source>E&amp;xpression</source>
        <translation>式(&amp;X)</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>範囲</translation>
    </message>
    <message>
        <source>x from</source>
        <translation>x の下限</translation>
    </message>
    <message>
        <source>x to</source>
        <translation>x の上限</translation>
    </message>
    <message>
        <source>y from</source>
        <translation>y の下限</translation>
    </message>
    <message>
        <source>y to</source>
        <translation>y の上限</translation>
    </message>
    <message>
        <source>On the plate</source>
        <translation>板の上</translation>
    </message>
    <message>
        <source>Width of the grooves in millimetres</source>
        <translation>溝の幅(ミリメートル)</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Groo&amp;ves</source>
        <translation>溝の幅(&amp;V)</translation>
    </message>
    <message>
        <source>Samples a side</source>
        <translation>一辺のサンプル数</translation>
    </message>
    <message>
        <source>Sam&amp;ples</source>
        <translation>細かさ(&amp;P)</translation>
    </message>
    <message>
        <source>Vol&amp;ume</source>
        <translation>音量(&amp;U)</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>音量</translation>
    </message>
    <message>
        <source>Column %1: %2; %3.</source>
        <translation>%1 文字目: %2; %3。</translation>
    </message>
    <message>
        <source>z from</source>
        <translation>z の下限</translation>
    </message>
    <message>
        <source>z to</source>
        <translation>z の上限</translation>
    </message>
    <message>
        <source>Of a surface; empty: as its values are</source>
        <translation>曲面の高さ。空欄なら値に合わせます</translation>
    </message>
</context>
<context>
    <name>nazori::ui::PointsPanel</name>
    <message>
        <source>Points of &amp;interest</source>
        <translation>注目点(&amp;I)</translation>
    </message>
    <message>
        <source>There are none in this window.</source>
        <translation>この範囲にはありません。</translation>
    </message>
    <message>
        <source>The drawing was stopped before points of interest were looked for.</source>
        <translation>注目点を調べる前に描画を止めました。</translation>
    </message>
    <message>
        <source>About the plot</source>
        <translation>グラフについて</translation>
    </message>
    <message>
        <source>Points of interest</source>
        <translation>注目点</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>, curves %1 and %2</source>
        <translation>、曲線 %1 と %2</translation>
    </message>
    <message>
        <source>, curve %1</source>
        <translation>、曲線 %1</translation>
    </message>
</context>
<context>
    <name>nazori::ui::Program</name>
    <message>
        <source>Nazori cannot start: %1.</source>
        <translation>Nazori を起動できません：%1。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::Progress</name>
    <message>
        <source>The statistics could not be read: %1.</source>
        <translation>統計を読めませんでした：%1。</translation>
    </message>
    <message>
        <source>P&amp;rogress</source>
        <translation>歩み(&amp;R)</translation>
    </message>
    <message>
        <source>What study has brought: charts and numbers</source>
        <translation>学習の成果：グラフと数字</translation>
    </message>
    <message>
        <source>Progress of %1</source>
        <translation>%1 の歩み</translation>
    </message>
    <message>
        <source>Everything is shown.</source>
        <translation>すべて表示しています。</translation>
    </message>
    <message>
        <source>A month is the shortest time.</source>
        <translation>一か月が最短です。</translation>
    </message>
    <message>
        <source>1 to %1 go to a chart, N shows its numbers, Ctrl+C copies them.</source>
        <translation>1～%1 でグラフへ、N で数字を表示、Ctrl+C でコピー。</translation>
    </message>
    <message>
        <source>%1: there are no numbers yet.</source>
        <translation>%1：まだ数字がありません。</translation>
    </message>
    <message>
        <source>The numbers of “%1” are copied, lines: %2.</source>
        <translation>「%1」の数字をコピーしました。行数：%2。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::ProgressActions</name>
    <message>
        <source>&amp;Every character</source>
        <translation>文字ごとの状態(&amp;E)</translation>
    </message>
    <message>
        <source>Go to the grid of characters</source>
        <translation>文字の一覧へ</translation>
    </message>
    <message>
        <source>&amp;Hardest strokes</source>
        <translation>苦手な画(&amp;H)</translation>
    </message>
    <message>
        <source>Go to the strokes that go wrong</source>
        <translation>まちがえる画へ</translation>
    </message>
    <message>
        <source>&amp;Numbers or drawing</source>
        <translation>数字か図(&amp;N)</translation>
    </message>
    <message>
        <source>Show the chart at hand as a table, or as a drawing again</source>
        <translation>今のグラフを表に、または図に戻す</translation>
    </message>
    <message>
        <source>Co&amp;py the numbers</source>
        <translation>数字をコピー(&amp;P)</translation>
    </message>
    <message>
        <source>Copy the numbers of the chart at hand</source>
        <translation>今のグラフの数字をコピー</translation>
    </message>
    <message>
        <source>&amp;Longer time</source>
        <translation>長い期間(&amp;L)</translation>
    </message>
    <message>
        <source>Show a longer time</source>
        <translation>もっと長い期間を表示</translation>
    </message>
    <message>
        <source>Shorter &amp;time</source>
        <translation>短い期間(&amp;T)</translation>
    </message>
    <message>
        <source>Show a shorter time</source>
        <translation>もっと短い期間を表示</translation>
    </message>
    <message>
        <source>&amp;Progress</source>
        <translation>歩み(&amp;P)</translation>
    </message>
</context>
<context>
    <name>nazori::ui::ProgressPage</name>
    <message>
        <source>Progress</source>
        <translation>歩み</translation>
    </message>
    <message>
        <source>Time s&amp;hown</source>
        <translation>期間(&amp;H)</translation>
    </message>
    <message>
        <source>Time shown</source>
        <translation>期間</translation>
    </message>
    <message>
        <source>A month</source>
        <translation>一か月</translation>
    </message>
    <message>
        <source>Three months</source>
        <translation>三か月</translation>
    </message>
    <message>
        <source>A year</source>
        <translation>一年</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>すべて</translation>
    </message>
    <message>
        <source>The log is added up</source>
        <translation>記録を集計しています</translation>
    </message>
    <message>
        <source>Nothing is studied yet. Begin with a few characters at Home, or trace one in Characters; what you do will stand here, with every number as text.</source>
        <translation>まだ何も学習していません。ホームで数文字から始めるか、文字の画面で一字なぞってください。したことがここに、すべての数字つきで並びます。</translation>
    </message>
    <message>
        <source>Days in a row: %1, longest %2%3</source>
        <translation>続いた日数：%1、最長 %2%3</translation>
    </message>
    <message>
        <source>; today is open</source>
        <translation>（今日はこれから）</translation>
    </message>
    <message>
        <source>; a day off this week is taken</source>
        <translation>（今週の休みは使いました）</translation>
    </message>
    <message>
        <source>Reviews: %1 in %2</source>
        <translation>復習：%1 回、%2</translation>
    </message>
    <message>
        <source>Recalled in 30 days: %1 of %2, predicted %3</source>
        <translation>30日間：%2 回のうち %1 思い出せた、予測 %3</translation>
    </message>
    <message>
        <source>Characters: %1 met, %2 learnt</source>
        <translation>文字：学んだ %1、身についた %2</translation>
    </message>
</context>
<context>
    <name>nazori::ui::SaveDialog</name>
    <message>
        <source>Save the tablet</source>
        <translation>文字板を保存</translation>
    </message>
    <message>
        <source>Height map, 8-bit RAW as in 2005</source>
        <translation>高さマップ（2005年と同じ8ビット RAW）</translation>
    </message>
    <message>
        <source>Height map, 16-bit PNG</source>
        <translation>高さマップ（16ビット PNG）</translation>
    </message>
    <message>
        <source>Stroke order, .str as in 2005</source>
        <translation>筆順（2005年と同じ .str）</translation>
    </message>
    <message>
        <source>%1 × %1, as in 2005</source>
        <translation>%1 × %1（2005年と同じ）</translation>
    </message>
    <message>
        <source>Choose the file…</source>
        <translation>ファイルを選ぶ…</translation>
    </message>
    <message>
        <source>&amp;Kind</source>
        <translation>種類(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation>大きさ(&amp;S)</translation>
    </message>
    <message>
        <source>Height maps (*.raw)</source>
        <translation>高さマップ (*.raw)</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>画像 (*.png)</translation>
    </message>
    <message>
        <source>Stroke orders (*.str)</source>
        <translation>筆順 (*.str)</translation>
    </message>
    <message>
        <source>%1 × %1</source>
        <translation>%1 × %1</translation>
    </message>
</context>
<context>
    <name>nazori::ui::SeatPanel</name>
    <message>
        <source>Looking for devices …</source>
        <translation>装置を探しています…</translation>
    </message>
    <message>
        <source>The tip is there</source>
        <translation>ペン先を置いた</translation>
    </message>
    <message>
        <source>Devices and how they stand</source>
        <translation>装置とその置き方</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>装置</translation>
    </message>
    <message>
        <source>Fit to the tablet</source>
        <translation>文字板に合わせる</translation>
    </message>
    <message>
        <source>Writing hand</source>
        <translation>書く手</translation>
    </message>
    <message>
        <source>Right hand writes</source>
        <translation>右手で書く</translation>
    </message>
    <message>
        <source>Left hand writes</source>
        <translation>左手で書く</translation>
    </message>
    <message>
        <source>Tilt of the tablet</source>
        <translation>文字板の傾き</translation>
    </message>
    <message>
        <source>%1°</source>
        <comment>angle, 90 upright</comment>
        <translation>%1°</translation>
    </message>
    <message>
        <source>Seat beside the device</source>
        <translation>装置に対する座る向き</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>Buttons of the stylus</source>
        <translation>ペンのボタン</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>何もしない</translation>
    </message>
    <message>
        <source>next stroke</source>
        <translation>次の画</translation>
    </message>
    <message>
        <source>previous stroke</source>
        <translation>前の画</translation>
    </message>
    <message>
        <source>all strokes</source>
        <translation>全画</translation>
    </message>
    <message>
        <source>wipe the ink off</source>
        <translation>墨を消す</translation>
    </message>
    <message>
        <source>First button</source>
        <translation>一つ目のボタン</translation>
    </message>
    <message>
        <source>Second button</source>
        <translation>二つ目のボタン</translation>
    </message>
    <message>
        <source>At most</source>
        <translation>上限</translation>
    </message>
    <message>
        <source>Force</source>
        <translation>力</translation>
    </message>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>Stiffness</source>
        <translation>硬さ</translation>
    </message>
    <message>
        <source>%1 N/m</source>
        <translation>%1 N/m</translation>
    </message>
    <message>
        <source>The best there is</source>
        <translation>いちばん良い装置</translation>
    </message>
    <message>
        <source>%1 – in use</source>
        <translation>%1 – 使用中</translation>
    </message>
    <message>
        <source>%1 – not there</source>
        <translation>%1 – 見つかりません</translation>
    </message>
    <message>
        <source>Fitted by corners: 1 cm of the hand is %1 cm on the tablet.</source>
        <translation>隅で合わせました。手の 1 cm が文字板の %1 cm です。</translation>
    </message>
    <message>
        <source>Fitted by itself: 1 cm of the hand is %1 cm on the tablet.</source>
        <translation>自動で合わせました。手の 1 cm が文字板の %1 cm です。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::SessionActions</name>
    <message>
        <source>&amp;Study what is due</source>
        <translation>今日の分を学習する(&amp;S)</translation>
    </message>
    <message>
        <source>Begin with what is due now</source>
        <translation>今の分から始めます</translation>
    </message>
    <message>
        <source>&amp;Go on</source>
        <translation>次へ(&amp;G)</translation>
    </message>
    <message>
        <source>To the next stage, or with the proposed rating</source>
        <translation>次の段階へ、または提案された評価で進みます</translation>
    </message>
    <message>
        <source>&amp;Again</source>
        <translation>もう一度(&amp;A)</translation>
    </message>
    <message>
        <source>Forgotten: it comes again soon</source>
        <translation>忘れていた：まもなくまた出ます</translation>
    </message>
    <message>
        <source>&amp;Hard</source>
        <translation>難しい(&amp;H)</translation>
    </message>
    <message>
        <source>Known with effort</source>
        <translation>苦労して思い出した</translation>
    </message>
    <message>
        <source>Goo&amp;d</source>
        <translation>できた(&amp;D)</translation>
    </message>
    <message>
        <source>Known</source>
        <translation>思い出した</translation>
    </message>
    <message>
        <source>&amp;Easy</source>
        <translation>簡単(&amp;E)</translation>
    </message>
    <message>
        <source>Known without effort</source>
        <translation>楽に思い出した</translation>
    </message>
    <message>
        <source>&amp;Take back the last review</source>
        <translation>最後の復習を取り消す(&amp;T)</translation>
    </message>
    <message>
        <source>Take back what was kept last; again for the one before, also of other days</source>
        <translation>最後に保存したものを取り消します。繰り返すと、その前のものや別の日のものも取り消せます</translation>
    </message>
    <message>
        <source>&amp;Postpone to tomorrow</source>
        <translation>明日にまわす(&amp;P)</translation>
    </message>
    <message>
        <source>This character comes tomorrow</source>
        <translation>この文字は明日出ます</translation>
    </message>
    <message>
        <source>Pa&amp;use or resume</source>
        <translation>休止・再開(&amp;U)</translation>
    </message>
    <message>
        <source>This character does not come until it is resumed</source>
        <translation>この文字は再開するまで出ません</translation>
    </message>
    <message>
        <source>&amp;Begin anew</source>
        <translation>初めからやり直す(&amp;B)</translation>
    </message>
    <message>
        <source>This character is new again</source>
        <translation>この文字は新しい文字に戻ります</translation>
    </message>
    <message>
        <source>&amp;Tags…</source>
        <translation>タグ(&amp;T)…</translation>
    </message>
    <message>
        <source>Words of your own for this character, to learn by</source>
        <translation>この文字に付ける自分の言葉。それで選んで学べます</translation>
    </message>
    <message>
        <source>End the &amp;session</source>
        <translation>学習を終える(&amp;S)</translation>
    </message>
    <message>
        <source>What was rated is kept</source>
        <translation>評価したものは保存されています</translation>
    </message>
    <message>
        <source>Study se&amp;ttings…</source>
        <translation>学習の設定(&amp;T)…</translation>
    </message>
    <message>
        <source>Limits, lists, order, desired retention</source>
        <translation>一日の量、リスト、順番、目標の定着率</translation>
    </message>
    <message>
        <source>St&amp;udy</source>
        <translation>学習(&amp;U)</translation>
    </message>
</context>
<context>
    <name>nazori::ui::SessionBar</name>
    <message>
        <source>Study session</source>
        <translation>学習中</translation>
    </message>
    <message>
        <source>How far the session is</source>
        <translation>学習の進み具合</translation>
    </message>
    <message>
        <source>hiragana for %1</source>
        <translation>%1 のひらがな</translation>
    </message>
    <message>
        <source>katakana for %1</source>
        <translation>%1 のカタカナ</translation>
    </message>
    <message numerus="yes">
        <source>a character of %n strokes</source>
        <translation>
            <numerusform>%n 画の文字</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 of %2 · %3 left</source>
        <translation>%2 のうち %1 · 残り %3</translation>
    </message>
    <message>
        <source>This character is not the one that is asked for.</source>
        <translation>これは今の問題の文字ではありません。</translation>
    </message>
    <message>
        <source>%1: %2, proposed</source>
        <translation>%1：%2、提案</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Back to the session  ⏎</source>
        <translation>学習に戻る  ⏎</translation>
    </message>
    <message>
        <source>Next character  ⏎</source>
        <translation>次の文字  ⏎</translation>
    </message>
    <message>
        <source>%1  ⏎</source>
        <translation>%1  ⏎</translation>
    </message>
</context>
<context>
    <name>nazori::ui::SessionPanel</name>
    <message>
        <source>The character that is studied</source>
        <translation>学習中の文字</translation>
    </message>
    <message>
        <source>Earlier writing</source>
        <translation>前に書いたもの</translation>
    </message>
    <message>
        <source>Once more today</source>
        <translation>今日もう一度</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>復習</translation>
    </message>
    <message>
        <source>Not yet written from memory.</source>
        <translation>まだ覚えて書いたことがありません。</translation>
    </message>
    <message numerus="yes">
        <source>Written from memory: %n times</source>
        <translation>
            <numerusform>覚えて書いた回数：%n</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Forgotten: %n times</source>
        <translation>
            <numerusform>忘れた回数：%n</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Stroke %1 went wrong %n times.</source>
        <translation>
            <numerusform>%1画目を %n 回間違えました。</numerusform>
        </translation>
    </message>
    <message>
        <source>now</source>
        <translation>今</translation>
    </message>
    <message>
        <source>Its parts: %1.</source>
        <translation>部分：%1</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes shown</source>
        <translation>
            <numerusform>見せた画 %n 画</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n hints</source>
        <translation>
            <numerusform>ヒント %n 回</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n misses</source>
        <translation>
            <numerusform>やり直し %n 回</numerusform>
        </translation>
    </message>
    <message>
        <source>“%1” is proposed: %2.</source>
        <translation>「%1」をすすめます: %2。</translation>
    </message>
    <message>
        <source>Pause</source>
        <translation>休止</translation>
    </message>
    <message>
        <source>Anew</source>
        <translation>初めから</translation>
    </message>
    <message>
        <source>End</source>
        <translation>終える</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>取り消す</translation>
    </message>
    <message>
        <source>Later</source>
        <translation>明日へ</translation>
    </message>
    <message>
        <source>Another lesson: often forgotten</source>
        <translation>別の練習：よく忘れる文字</translation>
    </message>
    <message>
        <source>New</source>
        <translation>新しい文字</translation>
    </message>
</context>
<context>
    <name>nazori::ui::SessionWords</name>
    <message>
        <source>What is due cannot be told: %1.</source>
        <translation>今日の分が分かりません：%1。</translation>
    </message>
    <message>
        <source>Nothing is due now.</source>
        <translation>今の分はありません。</translation>
    </message>
    <message>
        <source>The session has ended. Everything that was rated is kept.</source>
        <translation>学習を終えました。評価したものはすべて保存されています。</translation>
    </message>
    <message>
        <source>%1 is forgotten often. It is set apart: Home offers another lesson for it.</source>
        <translation>%1 はよく忘れるので取り分けました。ホームに別の練習があります。</translation>
    </message>
    <message>
        <source>Kept: %1 is “%2” and comes %3.</source>
        <translation>保存しました：%1 は「%2」、次は%3。</translation>
    </message>
    <message>
        <source>There is nothing to take back.</source>
        <translation>取り消すものはありません。</translation>
    </message>
    <message>
        <source>Taken back: the last writing of %1.</source>
        <translation>取り消しました：%1 の最後に書いたもの。</translation>
    </message>
    <message>
        <source>Taken back: %1 is not postponed.</source>
        <translation>取り消しました：%1 はまた予定どおりです。</translation>
    </message>
    <message>
        <source>Taken back: %1 is not paused.</source>
        <translation>取り消しました：%1 は休止していません。</translation>
    </message>
    <message>
        <source>Taken back: %1 is paused again.</source>
        <translation>取り消しました：%1 はまた休止です。</translation>
    </message>
    <message>
        <source>Taken back: what was learnt of %1 is there again.</source>
        <translation>取り消しました：%1 の学習が元に戻りました。</translation>
    </message>
    <message>
        <source>Taken back: %1.</source>
        <translation>取り消しました：%1。</translation>
    </message>
    <message>
        <source>%1 Ctrl+Shift+Z takes it back.</source>
        <translation>%1Ctrl+Shift+Z で取り消せます。</translation>
    </message>
    <message>
        <source>%1 comes tomorrow.</source>
        <translation>%1 は明日出ます。</translation>
    </message>
    <message>
        <source>%1 is paused until it is asked for.</source>
        <translation>%1 は再開するまで休みです。</translation>
    </message>
    <message>
        <source>%1 is new again.</source>
        <translation>%1 は新しい文字に戻りました。</translation>
    </message>
    <message>
        <source>That was all for now. Everything is kept.</source>
        <translation>今の分はこれで終わりです。すべて保存されています。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::SettingsProgress</name>
    <message>
        <source>Working out every character anew…</source>
        <translation>すべての漢字を計算し直しています…</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>止める</translation>
    </message>
    <message>
        <source>The study settings hold from now on.</source>
        <translation>学習の設定はこれから有効です。</translation>
    </message>
    <message>
        <source>Stopped. The study settings are as they were.</source>
        <translation>止めました。学習の設定は元のままです。</translation>
    </message>
    <message>
        <source>The study settings were not kept: %1. They are as they were.</source>
        <translation>学習の設定を保存できませんでした：%1。設定は元のままです。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::StageWords</name>
    <message>
        <source>Space plays, Left and Right step from stroke to stroke.</source>
        <translation>スペースキーで再生、左右の矢印キーで一画ずつ進みます。</translation>
    </message>
    <message>
        <source>Stroke %1 of %2</source>
        <translation>%1画目（全%2画）</translation>
    </message>
    <message>
        <source>%1. %2</source>
        <translation>%1。%2</translation>
    </message>
    <message>
        <source>%1: %2. %3</source>
        <translation>%1：%2。%3</translation>
    </message>
    <message numerus="yes">
        <source>All %n strokes. Space plays them again; F6 goes on to tracing.</source>
        <translation>
            <numerusform>全 %n 画です。スペースキーでもう一度再生、F6 でなぞりに進みます。</numerusform>
        </translation>
    </message>
    <message>
        <source>Speed %1.</source>
        <translation>速さ %1 倍です。</translation>
    </message>
    <message>
        <source>Press the left button to touch the tablet; the right button turns it.</source>
        <translation>左ボタンで文字板に触れ、右ボタンで回せます。</translation>
    </message>
    <message>
        <source>Press the left button in a groove and follow it. S shows the strokes.</source>
        <translation>溝の上で左ボタンを押し、溝に沿って動かしましょう。S キーで筆画が見えます。</translation>
    </message>
    <message>
        <source>Hold the left button at number 1 and draw along the groove.</source>
        <translation>番号 1 で左ボタンを押したまま、溝に沿って書きましょう。</translation>
    </message>
    <message>
        <source>Follow the groove.</source>
        <translation>溝に沿って書きましょう。</translation>
    </message>
    <message>
        <source>Write each stroke from its number.</source>
        <translation>番号のところから一画ずつ書きましょう。</translation>
    </message>
    <message>
        <source>Let the stylus take the hand along; hold back, and it gives way.</source>
        <translation>ペンが手を導くのに任せましょう。逆らうと力をゆるめます。</translation>
    </message>
    <message>
        <source>%1 Only a device with force leads the hand; here strokes hold it.</source>
        <translation>%1 手を導けるのは力覚デバイスだけです。ここでは画が引き寄せます。</translation>
    </message>
    <message>
        <source>%1 Without a slip so far: %2.</source>
        <translation>%1これまで %2 回、間違いなく書けました。</translation>
    </message>
    <message>
        <source>Stroke %1: follow the groove to its end.</source>
        <translation>%1画目：溝の終わりまでなぞりましょう。</translation>
    </message>
    <message>
        <source>Stroke %1 is written. The full stop key (.) shows the next.</source>
        <translation>%1画目が書けました。ピリオド（.）キーで次の画へ進みます。</translation>
    </message>
    <message>
        <source>Stroke %1 is written. Stroke %2 is next.</source>
        <translation>%1画目が書けました。次は%2画目です。</translation>
    </message>
    <message>
        <source>Stroke %1 is written, but stroke %2 is not finished: the blue bit is missing.</source>
        <translation>%1画目を書きましたが、%2画目は途中です。青い部分が残っています。</translation>
    </message>
    <message>
        <source>Stroke %1 is written, but stroke %2 comes first. Write it now.</source>
        <translation>%1画目を書きましたが、先に書くのは%2画目です。次に書いてください。</translation>
    </message>
    <message numerus="yes">
        <source>All %n strokes are written. Delete clears the tablet.</source>
        <translation>
            <numerusform>%n 画すべて書けました。Delete キーで墨を消せます。</numerusform>
        </translation>
    </message>
    <message>
        <source>Stroke %1 is not finished: the blue bit is missing. Draw on from there.</source>
        <translation>%1画目は途中です。青い部分を続けて書いてください。</translation>
    </message>
    <message>
        <source>Stroke %1 is not finished: draw the blue bit first.</source>
        <translation>%1画目は途中です。先に青い部分を書いてください。</translation>
    </message>
    <message>
        <source>Stroke %1 comes before stroke %2.</source>
        <translation>%1画目は%2画目より先に書きます。</translation>
    </message>
    <message>
        <source>Stroke %1 begins at its other end, where its number stands.</source>
        <translation>%1画目は反対の端、番号のある所から書き始めます。</translation>
    </message>
    <message>
        <source>Stroke %1 is shown. Draw it from its number.</source>
        <translation>%1画目を示しました。番号のところから書いてください。</translation>
    </message>
    <message>
        <source>The stylus gives way. Go on a little by yourself, and it leads again.</source>
        <translation>ペンが力をゆるめました。少し自分で進むと、また導きます。</translation>
    </message>
    <message>
        <source>Stroke %1 of %2. Draw it from its number.</source>
        <translation>%2画のうち%1画目です。番号から書きましょう。</translation>
    </message>
    <message>
        <source>Stroke %1 is chosen, but the strokes are hidden: press S.</source>
        <translation>%1画目を選びましたが、筆画は隠れています。S キーで見えます。</translation>
    </message>
    <message>
        <source>The stylus is free.</source>
        <translation>ペン先は自由に動きます。</translation>
    </message>
    <message>
        <source>Strokes now hold the stylus. Pull away firmly to leave one.</source>
        <translation>画がペン先を引き留めます。強く引くと離れます。</translation>
    </message>
    <message>
        <source>Strokes hold the stylus only while they are shown: press S.</source>
        <translation>画が見えている間だけ吸着します。S キーで筆画を見せてください。</translation>
    </message>
    <message>
        <source>All strokes are there, not all at their turn. Delete clears the tablet.</source>
        <translation>全部の画が書けましたが、順番や向きが違う画がありました。Delete で消してもう一度書けます。</translation>
    </message>
    <message>
        <source>All strokes are there, not all at their turn.</source>
        <translation>すべての画がありますが、順番どおりではないものがあります。</translation>
    </message>
    <message>
        <source>Without a slip.</source>
        <translation>間違いなく書けました。</translation>
    </message>
    <message>
        <source>Without a slip. There is less help now: write it again.</source>
        <translation>間違いなく書けました。助けを減らします。もう一度書きましょう。</translation>
    </message>
    <message>
        <source>Without a slip, and without help. F8 goes on to writing from memory.</source>
        <translation>助けなしで間違いなく書けました。F8 で覚えて書く練習に進めます。</translation>
    </message>
    <message>
        <source>Nothing is written yet. H shows the first stroke.</source>
        <translation>まだ何も書かれていません。H で最初の画を見せます。</translation>
    </message>
    <message>
        <source>The tablet is full. Delete clears it.</source>
        <translation>文字板がいっぱいです。Delete で消せます。</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes are written. Enter judges them.</source>
        <translation>
            <numerusform>%n 画書きました。Enter で判定します。</numerusform>
        </translation>
    </message>
    <message>
        <source>Stroke %1 is shown in blue. Write it there and go on.</source>
        <translation>%1画目を青で示しました。そこに書いて続けてください。</translation>
    </message>
    <message>
        <source>Stroke %1 is right. Enter is done.</source>
        <translation>%1画目は正しく書けました。Enter で判定します。</translation>
    </message>
    <message numerus="yes">
        <source>Stroke %1 is right. %n to go.</source>
        <translation>
            <numerusform>%1画目は正しく書けました。あと %n 画です。</numerusform>
        </translation>
    </message>
    <message>
        <source>Stroke %1 is right. Stroke %2 is still missing.</source>
        <translation>%1画目は正しく書けました。%2画目がまだありません。</translation>
    </message>
    <message>
        <source>The writing could not be judged: %1. It is kept.</source>
        <translation>判定できませんでした：%1。書いた字はそのままです。</translation>
    </message>
    <message numerus="yes">
        <source>Taken back. %n strokes are written.</source>
        <translation>
            <numerusform>取り消しました。今は %n 画です。</numerusform>
        </translation>
    </message>
    <message>
        <source>Every stroke is there. Enter is done.</source>
        <translation>すべての画が書けています。Enter で判定します。</translation>
    </message>
    <message>
        <source>Stroke %1 is shown in blue. H again shows all that are left.</source>
        <translation>%1画目を青で示しました。もう一度 H を押すと残り全部を示します。</translation>
    </message>
    <message>
        <source>All strokes that are left are shown in blue.</source>
        <translation>残りの画をすべて青で示しました。</translation>
    </message>
    <message>
        <source>This is how it is written. Delete clears the tablet to try again.</source>
        <translation>こう書きます。Delete で消して、もう一度書けます。</translation>
    </message>
    <message>
        <source>Every stroke is judged as it ends.</source>
        <translation>一画ごとに判定します。</translation>
    </message>
    <message>
        <source>The writing is judged at the end: press Enter.</source>
        <translation>最後に判定します。Enter を押してください。</translation>
    </message>
    <message numerus="yes">
        <source>Write the character of %n strokes.</source>
        <translation>
            <numerusform>%n 画の字を書きましょう。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 H gives a hint, Enter is done.</source>
        <translation>%1H でヒント、Enter で終わりです。</translation>
    </message>
    <message>
        <source>%1: %2 H gives a hint, Enter is done.</source>
        <translation>%1：%2H でヒント、Enter で判定します。</translation>
    </message>
    <message>
        <source>That is no stroke of this character. Ctrl+Z takes it back.</source>
        <translation>この字にない画です。Ctrl+Z で取り消せます。</translation>
    </message>
    <message>
        <source>%1 H shows where the stroke goes.</source>
        <translation>%1H キーで書く場所を示します。</translation>
    </message>
    <message>
        <source>%1 Ctrl+Z takes back a stroke, O shows the model.</source>
        <translation>%1Ctrl+Z で一画取り消し、O で手本を重ねます。</translation>
    </message>
    <message>
        <source>%1 %2 of 100 points.</source>
        <translation>%1 %2 点（100 点満点）です。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::StatusLine</name>
    <message>
        <source>Writing %1: %2 %</source>
        <translation>%1 を書き出し中：%2 %</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>待機中</translation>
    </message>
    <message>
        <source>How often a second the stylus is felt</source>
        <translation>ペン先の感触を1秒に計算する回数</translation>
    </message>
    <message>
        <source>Moments of feeling that came too late or not at all, since the start</source>
        <translation>起動してから、間に合わなかった、または抜けた回数</translation>
    </message>
    <message>
        <source>%1, without force</source>
        <translation>%1（力覚なし）</translation>
    </message>
    <message>
        <source>depth %1 mm</source>
        <translation>深さ %1 mm</translation>
    </message>
    <message>
        <source>%1 times a second</source>
        <translation>毎秒 %1 回</translation>
    </message>
    <message>
        <source>starting</source>
        <translation>開始中</translation>
    </message>
    <message>
        <source>How long a moment of feeling takes to compute on average, how late one came at most since the start, and how old the drawn stylus was at most in the last second</source>
        <translation>力覚の計算一回にかかる平均時間、開始から今までの最大の遅れ、直前の一秒間に描いたペン先の最大の古さ</translation>
    </message>
    <message>
        <source>tick %1 µs, late %2 ms</source>
        <translation>一回 %1 µs・遅れ %2 ms</translation>
    </message>
    <message>
        <source>%1, seen after %2 ms</source>
        <translation>%1・表示まで %2 ms</translation>
    </message>
    <message>
        <source>%1 missed</source>
        <translation>抜け %1 回</translation>
    </message>
    <message>
        <source>● %1, %2 s</source>
        <translation>● %1、%2 秒</translation>
    </message>
    <message>
        <source>%1, %2 lost</source>
        <translation>%1、抜け %2</translation>
    </message>
    <message>
        <source>The session is being recorded to %1</source>
        <translation>%1 に記録しています</translation>
    </message>
</context>
<context>
    <name>nazori::ui::StrengthModel</name>
    <message>
        <source>%1, %2</source>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>%1, %2, known with a chance of %3</source>
        <translation>%1、%2、思い出せる見込み %3</translation>
    </message>
</context>
<context>
    <name>nazori::ui::StrictnessSlider</name>
    <message>
        <source>&amp;Judged</source>
        <translation>採点(&amp;J)</translation>
    </message>
    <message>
        <source>Strictness</source>
        <translation>採点の厳しさ</translation>
    </message>
    <message>
        <source>How strictly writing is judged (Ctrl+[ and Ctrl+])</source>
        <translation>採点の厳しさ（Ctrl+[ と Ctrl+]）</translation>
    </message>
    <message>
        <source>lenient</source>
        <translation>甘い</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>ふつう</translation>
    </message>
    <message>
        <source>strict</source>
        <translation>厳しい</translation>
    </message>
    <message>
        <source>leniently</source>
        <translation>甘く</translation>
    </message>
    <message>
        <source>strictly</source>
        <translation>厳しく</translation>
    </message>
    <message>
        <source>as a teacher does</source>
        <translation>先生のように</translation>
    </message>
    <message>
        <source>rather leniently</source>
        <translation>やや甘く</translation>
    </message>
    <message>
        <source>rather strictly</source>
        <translation>やや厳しく</translation>
    </message>
</context>
<context>
    <name>nazori::ui::StrokeCounter</name>
    <message>
        <source>no strokes</source>
        <translation>筆画なし</translation>
    </message>
    <message numerus="yes">
        <source>all %n strokes</source>
        <translation>
            <numerusform>全 %n 画</numerusform>
        </translation>
    </message>
    <message>
        <source>stroke %1 of %2</source>
        <translation>%1画目（全%2画）</translation>
    </message>
</context>
<context>
    <name>nazori::ui::StrokeWords</name>
    <message>
        <source>horizontal line</source>
        <translation>横画</translation>
    </message>
    <message>
        <source>vertical line</source>
        <translation>縦画</translation>
    </message>
    <message>
        <source>sweep to the left</source>
        <translation>左払い</translation>
    </message>
    <message>
        <source>sweep to the right</source>
        <translation>右払い</translation>
    </message>
    <message>
        <source>dot</source>
        <translation>点</translation>
    </message>
    <message>
        <source>rising stroke</source>
        <translation>はね上げ</translation>
    </message>
    <message>
        <source>horizontal line with a hook</source>
        <translation>横画かぎ</translation>
    </message>
    <message>
        <source>vertical line with a hook</source>
        <translation>縦画はね</translation>
    </message>
    <message>
        <source>horizontal line that turns down</source>
        <translation>横折れ</translation>
    </message>
    <message>
        <source>horizontal line that turns down, with a hook</source>
        <translation>横折れはね</translation>
    </message>
    <message>
        <source>vertical line that turns right</source>
        <translation>縦折れ</translation>
    </message>
    <message>
        <source>vertical line that bends right, with a hook</source>
        <translation>縦曲がりはね</translation>
    </message>
    <message>
        <source>vertical line with a rise</source>
        <translation>縦はね上げ</translation>
    </message>
    <message>
        <source>horizontal line that sweeps to the left</source>
        <translation>横左払い</translation>
    </message>
    <message>
        <source>curved line with a hook</source>
        <translation>曲がりはね</translation>
    </message>
    <message>
        <source>slanting line with a hook</source>
        <translation>そりはね</translation>
    </message>
    <message>
        <source>flat curve with a hook</source>
        <translation>平そりはね</translation>
    </message>
    <message>
        <source>horizontal line that bends, with a hook</source>
        <translation>横曲がりはね</translation>
    </message>
    <message>
        <source>horizontal line that turns down, then rises</source>
        <translation>横折れはね上げ</translation>
    </message>
    <message>
        <source>sweep to the left that turns right</source>
        <translation>左払い折れ</translation>
    </message>
    <message>
        <source>sweep to the left that turns to a dot</source>
        <translation>左払い点</translation>
    </message>
    <message>
        <source>line with three turns</source>
        <translation>三つ折れ</translation>
    </message>
    <message>
        <source>line with several turns and a hook</source>
        <translation>折れ重なりはね</translation>
    </message>
    <message>
        <source>line with two turns that sweeps to the left</source>
        <translation>二つ折れ左払い</translation>
    </message>
    <message>
        <source>line that turns and curves, with a hook</source>
        <translation>横折れ曲がりはね</translation>
    </message>
    <message>
        <source>It stops at the end.</source>
        <translation>終わりは止めます。</translation>
    </message>
    <message>
        <source>It stops, then kicks.</source>
        <translation>止めてから、はねます。</translation>
    </message>
    <message>
        <source>It is lifted while it moves, and thins out.</source>
        <translation>動かしながら筆を上げ、払います。</translation>
    </message>
    <message>
        <source>It may stop or thin out.</source>
        <translation>止めても払ってもかまいません。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::StudyCharts</name>
    <message>
        <source>Day</source>
        <translation>日</translation>
    </message>
    <message>
        <source>Week from</source>
        <translation>週（始まり）</translation>
    </message>
    <message>
        <source>Month from</source>
        <translation>月（始まり）</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 分</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1 時間 %2 分</translation>
    </message>
    <message>
        <source>not met</source>
        <translation>まだ</translation>
    </message>
    <message>
        <source>learning</source>
        <translation>学習中</translation>
    </message>
    <message>
        <source>young</source>
        <translation>覚えたて</translation>
    </message>
    <message>
        <source>firm</source>
        <translation>定着</translation>
    </message>
    <message>
        <source>set apart</source>
        <translation>取り分け</translation>
    </message>
    <message>
        <source>paused</source>
        <translation>休止中</translation>
    </message>
    <message>
        <source>out of turn</source>
        <translation>順番ちがい</translation>
    </message>
    <message>
        <source>drawn backwards</source>
        <translation>逆向き</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>書き忘れ</translation>
    </message>
    <message>
        <source>one too many</source>
        <translation>余分な画</translation>
    </message>
    <message>
        <source>joined with another</source>
        <translation>ほかの画とつながった</translation>
    </message>
    <message>
        <source>drawn in pieces</source>
        <translation>切れた</translation>
    </message>
    <message>
        <source>wrong shape or place</source>
        <translation>形か位置がちがう</translation>
    </message>
    <message>
        <source>of another character</source>
        <translation>ほかの文字の画</translation>
    </message>
    <message>
        <source>wrong ending</source>
        <translation>とめ・はね・はらいのちがい</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>a fault, how often</comment>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>Reviews to come</source>
        <translation>これからの復習</translation>
    </message>
    <message>
        <source>Write a character from memory once, and the day it comes back stands here.</source>
        <translation>一度そらで書くと、次に出る日がここに並びます。</translation>
    </message>
    <message>
        <source>Reviews</source>
        <translation>復習</translation>
    </message>
    <message>
        <source>In 30 days: %1, today: %2. Most on %3: %4.</source>
        <translation>30日間：%1、今日：%2。最も多いのは %3：%4。</translation>
    </message>
    <message>
        <source>Reviews and minutes</source>
        <translation>復習と時間</translation>
    </message>
    <message>
        <source>Nothing was written in this time. What you write stands here, day by day.</source>
        <translation>この期間には何も書いていません。書いたものが日ごとに並びます。</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>練習</translation>
    </message>
    <message>
        <source>New</source>
        <translation>新しい文字</translation>
    </message>
    <message>
        <source>Minutes</source>
        <translation>分</translation>
    </message>
    <message>
        <source>Reviews: %1 in %2. Days of study: %3, each with about %4 reviews in %5 min.</source>
        <translation>復習：%1 回、%2。学習した日：%3 日、一日におよそ %4 回、%5 分。</translation>
    </message>
    <message>
        <source>Recalled, and predicted</source>
        <translation>思い出せた率と予測</translation>
    </message>
    <message>
        <source>Counted once a character comes back after a day or more. Come back tomorrow.</source>
        <translation>一日以上たって文字がまた出ると数えます。明日また来てください。</translation>
    </message>
    <message>
        <source>Recalled</source>
        <translation>思い出せた</translation>
    </message>
    <message>
        <source>Predicted</source>
        <translation>予測</translation>
    </message>
    <message>
        <source>Reviews after a day or more: %1. Recalled %2, predicted %3.</source>
        <translation>一日以上たってからの復習：%1 回。思い出せた %2、予測 %3。</translation>
    </message>
    <message>
        <source>Speed and smoothness of the pen</source>
        <translation>筆の速さとなめらかさ</translation>
    </message>
    <message>
        <source>Shown once characters were written on the tablet, with pen, mouse or stylus.</source>
        <translation>ペン、マウス、スタイラスで文字を書くと表示されます。</translation>
    </message>
    <message>
        <source>Writings</source>
        <translation>書いた回数</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>速さ</translation>
    </message>
    <message>
        <source>Smoothness</source>
        <translation>なめらかさ</translation>
    </message>
    <message>
        <source>Speed %1 at first, %2 now, in character widths a second. Smoothness %3 at first, %4 now; nearer to 0 is smoother.</source>
        <translation>速さは初め毎秒 %1 字幅、今は %2。なめらかさは初め %3、今は %4。0 に近いほどなめらかです。</translation>
    </message>
    <message>
        <source>Character</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>Stroke</source>
        <translation>画</translation>
    </message>
    <message>
        <source>Wrong in</source>
        <translation>まちがい</translation>
    </message>
    <message>
        <source>How</source>
        <translation>どのように</translation>
    </message>
    <message>
        <source>Reviews to &amp;come</source>
        <translation>これからの復習(&amp;C)</translation>
    </message>
    <message>
        <source>Go to the reviews to come</source>
        <translation>これからの復習へ</translation>
    </message>
    <message>
        <source>&amp;Recalled, and predicted</source>
        <translation>思い出せた率と予測(&amp;R)</translation>
    </message>
    <message>
        <source>Go to what was recalled and predicted</source>
        <translation>思い出せた率と予測へ</translation>
    </message>
    <message>
        <source>Reviews and &amp;minutes</source>
        <translation>復習と時間(&amp;M)</translation>
    </message>
    <message>
        <source>Go to the reviews and minutes</source>
        <translation>復習と時間へ</translation>
    </message>
    <message>
        <source>&amp;Speed and smoothness</source>
        <translation>速さとなめらかさ(&amp;S)</translation>
    </message>
    <message>
        <source>Go to how the pen moved</source>
        <translation>筆の動きへ</translation>
    </message>
</context>
<context>
    <name>nazori::ui::StudySettingsDialog</name>
    <message>
        <source>Your lists and tags cannot be read: %1</source>
        <translation>自分のリストとタグを読めません：%1</translation>
    </message>
    <message>
        <source>The study settings hold from now on.</source>
        <translation>学習の設定はこれから有効です。</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>タグ</translation>
    </message>
    <message>
        <source>Tags of %1, with commas between them:</source>
        <translation>%1 のタグ（コンマで区切ります）：</translation>
    </message>
    <message>
        <source>Study settings</source>
        <translation>学習の設定</translation>
    </message>
    <message>
        <source>How much</source>
        <translation>量</translation>
    </message>
    <message>
        <source>Desired retention</source>
        <translation>目標の定着率</translation>
    </message>
    <message>
        <source>&amp;New characters a day, at most</source>
        <translation>一日の新しい文字の上限(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Reviews a day, at most</source>
        <translation>一日の復習の上限(&amp;R)</translation>
    </message>
    <message>
        <source>A study &amp;day begins at (hour)</source>
        <translation>学習の一日が始まる時刻（時）(&amp;D)</translation>
    </message>
    <message>
        <source>Time zone</source>
        <translation>時間帯</translation>
    </message>
    <message>
        <source>as the computer</source>
        <translation>コンピューターと同じ</translation>
    </message>
    <message>
        <source>Time &amp;zone</source>
        <translation>時間帯(&amp;Z)</translation>
    </message>
    <message>
        <source>What</source>
        <translation>内容</translation>
    </message>
    <message>
        <source>Order of new characters</source>
        <translation>新しい文字の順番</translation>
    </message>
    <message>
        <source>by school grade</source>
        <translation>学年順</translation>
    </message>
    <message>
        <source>commonest first</source>
        <translation>よく使う順</translation>
    </message>
    <message>
        <source>fewest strokes first</source>
        <translation>画数の少ない順</translation>
    </message>
    <message>
        <source>parts before wholes</source>
        <translation>部分から全体へ</translation>
    </message>
    <message>
        <source>as in the lists</source>
        <translation>リストの順</translation>
    </message>
    <message>
        <source>&amp;Order of new characters</source>
        <translation>新しい文字の順番(&amp;O)</translation>
    </message>
    <message>
        <source>Lists to learn from</source>
        <translation>学ぶリスト</translation>
    </message>
    <message>
        <source>New list…</source>
        <translation>新しいリスト…</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>上へ</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>下へ</translation>
    </message>
    <message>
        <source>Postpone all…</source>
        <translation>すべて延ばす…</translation>
    </message>
    <message>
        <source>Postpone</source>
        <translation>延ばす</translation>
    </message>
    <message>
        <source>Days</source>
        <translation>日数</translation>
    </message>
    <message numerus="yes">
        <source>%n characters are postponed.</source>
        <translation>
            <numerusform>%n 字を延ばしました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Pause all</source>
        <translation>すべて休止</translation>
    </message>
    <message numerus="yes">
        <source>%n characters are paused.</source>
        <translation>
            <numerusform>%n 字を休止しました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Resume all</source>
        <translation>すべて再開</translation>
    </message>
    <message numerus="yes">
        <source>%n characters come again.</source>
        <translation>
            <numerusform>%n 字がまた出ます。</numerusform>
        </translation>
    </message>
    <message>
        <source>Begin all anew</source>
        <translation>すべて初めから</translation>
    </message>
    <message numerus="yes">
        <source>%n characters are new again.</source>
        <translation>
            <numerusform>%n 字が新しい文字に戻りました。</numerusform>
        </translation>
    </message>
    <message>
        <source>How</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>Misses of a stroke until a &amp;hint is offered</source>
        <translation>ヒントを勧めるまでの一画の失敗の数(&amp;H)</translation>
    </message>
    <message>
        <source>Misses until the stroke is &amp;shown</source>
        <translation>画を示すまでの失敗の数(&amp;S)</translation>
    </message>
    <message>
        <source>Forgotten so often, a character gets another &amp;lesson</source>
        <translation>この回数忘れた文字は別の練習へ(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Vary intervals a little</source>
        <translation>間隔を少しずらす(&amp;V)</translation>
    </message>
    <message>
        <source>Choose the &amp;emptier day</source>
        <translation>少ない日を選ぶ(&amp;E)</translation>
    </message>
    <message>
        <source>FSRS weights of your own…</source>
        <translation>自分の FSRS の重み…</translation>
    </message>
    <message>
        <source>The usual weights</source>
        <translation>標準の重み</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>窓</translation>
    </message>
    <message>
        <source>Nazori opens with &amp;Home</source>
        <translation>ホームから始める(&amp;H)</translation>
    </message>
    <message>
        <source>Ask by a &amp;word at times, the character left out</source>
        <translation>ときどき、文字を抜いた熟語で尋ねる(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Left-handed: what stands beside the tablet changes sides</source>
        <translation>左利き：文字板の左右を入れ替える(&amp;L)</translation>
    </message>
    <message>
        <source>Keys for one hand</source>
        <translation>片手のキー</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>left hand: 1 2 3 4, E goes on, W hint, X takes back</source>
        <translation>左手：1 2 3 4、E で次へ、W でヒント、X で取り消し</translation>
    </message>
    <message>
        <source>right hand: 7 8 9 0, K goes on, U hint, Backspace takes back</source>
        <translation>右手：7 8 9 0、K で次へ、U でヒント、Backspace で取り消し</translation>
    </message>
    <message>
        <source>&amp;Keys for one hand</source>
        <translation>片手のキー(&amp;K)</translation>
    </message>
    <message numerus="yes">
        <source>With %1 new a day about %2 reviews and %n minutes a day; after a year about %3 characters known. Higher retention means more reviews.</source>
        <translation>
            <numerusform>一日に新しい文字 %1 字なら、一日およそ復習 %2 件、%n 分。一年後にはおよそ %3 字を覚えています。定着率を高くすると復習が増えます。</numerusform>
        </translation>
    </message>
    <message>
        <source>No list is chosen: nothing new will come.</source>
        <translation>リストが選ばれていません。新しい文字は出ません。</translation>
    </message>
    <message numerus="yes">
        <source>%Ln characters are chosen, %1 of them met already.</source>
        <translation>
            <numerusform>%Ln 字が選ばれ、そのうち %1 字はもう学び始めました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Only lists of your own can be removed.</source>
        <translation>削除できるのは自分のリストだけです。</translation>
    </message>
    <message>
        <source>Remove the list</source>
        <translation>リストの削除</translation>
    </message>
    <message>
        <source>Remove “%1”? What was learnt of its characters stays.</source>
        <translation>「%1」を削除しますか。その文字の学習は残ります。</translation>
    </message>
    <message>
        <source>There is nothing in this list.</source>
        <translation>このリストには何もありません。</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Z takes it back.</source>
        <translation>Ctrl+Shift+Z で取り消せます。</translation>
    </message>
    <message>
        <source>FSRS-6 with its usual weights.</source>
        <translation>FSRS-6、標準の重み。</translation>
    </message>
    <message>
        <source>FSRS-6 with weights of your own, the first %1.</source>
        <translation>FSRS-6、自分の重み（最初は %1）。</translation>
    </message>
    <message>
        <source>FSRS weights</source>
        <translation>FSRS の重み</translation>
    </message>
    <message>
        <source>21, 19 or 17 numbers, as Anki shows them:</source>
        <translation>Anki が示すとおりの 21、19 または 17 個の数：</translation>
    </message>
    <message>
        <source>These weights are not taken: %1.</source>
        <translation>この重みは使えません：%1。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::StudyWords</name>
    <message>
        <source>Again</source>
        <translation>もう一度</translation>
    </message>
    <message>
        <source>Hard</source>
        <translation>難しい</translation>
    </message>
    <message>
        <source>Good</source>
        <translation>できた</translation>
    </message>
    <message>
        <source>Easy</source>
        <translation>簡単</translation>
    </message>
    <message>
        <source>Watch</source>
        <translation>見る</translation>
    </message>
    <message>
        <source>Trace</source>
        <translation>なぞる</translation>
    </message>
    <message>
        <source>Guided</source>
        <translation>導き</translation>
    </message>
    <message>
        <source>From memory</source>
        <translation>覚えて書く</translation>
    </message>
    <message numerus="yes">
        <source>in %n minutes</source>
        <translation>
            <numerusform>%n 分後</numerusform>
        </translation>
    </message>
    <message>
        <source>tomorrow</source>
        <translation>明日</translation>
    </message>
    <message numerus="yes">
        <source>in %n days</source>
        <translation>
            <numerusform>%n 日後</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>in %n months</source>
        <translation>
            <numerusform>%n か月後</numerusform>
        </translation>
    </message>
    <message>
        <source>in %1 years</source>
        <translation>%1 年後</translation>
    </message>
    <message>
        <source>less than a minute</source>
        <translation>一分足らず</translation>
    </message>
    <message numerus="yes">
        <source>about %n minutes</source>
        <translation>
            <numerusform>約 %n 分</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1 分</translation>
    </message>
    <message>
        <source>%1 d</source>
        <translation>%1 日</translation>
    </message>
    <message>
        <source>%1 mo</source>
        <translation>%1 か月</translation>
    </message>
    <message>
        <source>%1 y</source>
        <translation>%1 年</translation>
    </message>
</context>
<context>
    <name>nazori::ui::ToolBar</name>
    <message>
        <source>How the tablet looks (Ctrl+1, 2, 3)</source>
        <translation>文字板の見た目 (Ctrl+1, 2, 3)</translation>
    </message>
    <message>
        <source>Look of the tablet: %1</source>
        <translation>文字板の見た目：%1</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>道具</translation>
    </message>
</context>
<context>
    <name>nazori::ui::WatchPage</name>
    <message>
        <source>%1 of %2 · × %3</source>
        <translation>%1 / %2 画 · × %3</translation>
    </message>
    <message>
        <source>no strokes</source>
        <translation>筆画なし</translation>
    </message>
</context>
<context>
    <name>nazori::ui::WorkplaceRail</name>
    <message>
        <source>Workplaces</source>
        <translation>作業の場</translation>
    </message>
</context>
<context>
    <name>nazori::ui::WritingPanel</name>
    <message>
        <source>Your writing</source>
        <translation>あなたの字</translation>
    </message>
</context>
<context>
    <name>nazori::ui::WritingReport</name>
    <message>
        <source>What was found in your writing</source>
        <translation>書いた字の講評</translation>
    </message>
    <message>
        <source>Accepted: %1 of 100 points</source>
        <translation>合格：100点中%1点</translation>
    </message>
    <message>
        <source>Not yet: %1 of 100 points</source>
        <translation>もう少し：100点中%1点</translation>
    </message>
</context>
<context>
    <name>nazori::ui::plot_words</name>
    <message>
        <source>infinity</source>
        <translation>無限大</translation>
    </message>
    <message>
        <source>minus infinity</source>
        <translation>マイナス無限大</translation>
    </message>
    <message>
        <source>minus %1</source>
        <translation>マイナス%1</translation>
    </message>
    <message>
        <source>The curve is upright here.</source>
        <translation>ここでは曲線が垂直です。</translation>
    </message>
    <message>
        <source>slope %1</source>
        <translation>傾き %1</translation>
    </message>
    <message>
        <source>x from %1 to %2, one tick is %3; y from %4 to %5, one tick is %6</source>
        <translation>x は %1 から %2、1 目盛りは %3。y は %4 から %5、1 目盛りは %6</translation>
    </message>
    <message>
        <source>There is no other curve or branch.</source>
        <translation>ほかの曲線や枝はありません。</translation>
    </message>
    <message>
        <source>Next piece</source>
        <translation>次の部分</translation>
    </message>
    <message>
        <source>End</source>
        <translation>端</translation>
    </message>
    <message>
        <source>Beacon %1</source>
        <translation>目印 %1</translation>
    </message>
    <message>
        <source>Beacon %1 is here: %2.</source>
        <translation>目印 %1 をここに置きました: %2。</translation>
    </message>
    <message>
        <source>Curve %1 alone: %2.</source>
        <translation>曲線 %1 だけ: %2。</translation>
    </message>
    <message>
        <source>All curves are shown.</source>
        <translation>すべての曲線を表示しています。</translation>
    </message>
    <message>
        <source>Piece %1 of %2: %3</source>
        <translation>%2 本中 %1 本目: %3</translation>
    </message>
    <message numerus="yes">
        <source>%n pieces</source>
        <translation>
            <numerusform>曲線 %n 本</numerusform>
        </translation>
    </message>
    <message>
        <source>Speed %1 of %2</source>
        <translation>速さ %2 段階の %1</translation>
    </message>
    <message>
        <source>There is no curve to follow here.</source>
        <translation>ここにはたどる曲線がありません。</translation>
    </message>
    <message>
        <source>There are no points of interest in this window.</source>
        <translation>この範囲に注目点はありません。</translation>
    </message>
    <message>
        <source>Go to a place on a curve first, with the arrow keys.</source>
        <translation>まず矢印キーで曲線上の場所へ移ってください。</translation>
    </message>
    <message>
        <source>There is no slope here.</source>
        <translation>ここには傾きがありません。</translation>
    </message>
    <message>
        <source>There is no beacon yet. B drops one.</source>
        <translation>目印はまだありません。B で置けます。</translation>
    </message>
    <message>
        <source>There is only one curve.</source>
        <translation>曲線は一本だけです。</translation>
    </message>
    <message>
        <source>The window cannot be changed any further.</source>
        <translation>範囲はこれ以上変えられません。</translation>
    </message>
    <message>
        <source>Plots (*.json)</source>
        <translation>グラフ (*.json)</translation>
    </message>
    <message>
        <source>Height maps (*.raw)</source>
        <translation>高さマップ (*.raw)</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>画像 (*.png)</translation>
    </message>
    <message>
        <source>Sounds (*.wav)</source>
        <translation>音声 (*.wav)</translation>
    </message>
</context>
<context>
    <name>nazori::ui::reason</name>
    <message>
        <source>a value is out of range</source>
        <translation>値が範囲を外れています</translation>
    </message>
    <message>
        <source>it could not be read or written</source>
        <translation>読み書きできませんでした</translation>
    </message>
    <message>
        <source>its content does not follow the format</source>
        <translation>内容が形式に合っていません</translation>
    </message>
    <message>
        <source>it is of another kind than expected</source>
        <translation>種類が違います</translation>
    </message>
    <message>
        <source>it does not exist</source>
        <translation>存在しません</translation>
    </message>
    <message>
        <source>Nothing can be heard: no sound card answers (%1). Plug in or switch on loudspeakers or headphones; everything else works.</source>
        <translation>音を出せません。使えるサウンドカードがありません（%1）。スピーカーかヘッドホンをつなぐか、電源を入れてください。ほかはすべて使えます。</translation>
    </message>
    <message>
        <source>the graphics or the device refused</source>
        <translation>グラフィックスまたは装置が応じません</translation>
    </message>
    <message>
        <source>it was stopped</source>
        <translation>中止されました</translation>
    </message>
    <message>
        <source>another program is using it</source>
        <translation>ほかのプログラムが使用中です</translation>
    </message>
</context>
</TS>
