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
        <translation>彫られた漢字を、見て、触れて、なぞって学ぶ</translation>
    </message>
    <message>
        <source>Licences</source>
        <translation>ライセンス</translation>
    </message>
    <message>
        <source>Nazori (program)</source>
        <translation>Nazori（プログラム本体）</translation>
    </message>
    <message>
        <source>Strokes: KanjiVG, © Ulrich Apel</source>
        <translation>画のデータ：KanjiVG © Ulrich Apel</translation>
    </message>
    <message>
        <source>Readings, meanings and words: KANJIDIC2 and EDICT, © EDRDG</source>
        <translation>読み・意味・言葉：KANJIDIC2、EDICT © EDRDG</translation>
    </message>
    <message>
        <source>Textbook font: Klee One, © Fontworks Inc.</source>
        <translation>教科書体風のフォント：クレー One © Fontworks Inc.</translation>
    </message>
    <message>
        <source>User interface: Qt %1</source>
        <translation>ユーザーインターフェース：Qt %1</translation>
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
        <source>Open a height map (RAW, PNG) or a stroke order file (.str)</source>
        <translation>高さマップ（RAW、PNG）または書き順（.str）を開きます</translation>
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
        <translation>クラシック(&amp;C)</translation>
    </message>
    <message>
        <source>The look of the 2005 program</source>
        <translation>2005年版の見た目</translation>
    </message>
    <message>
        <source>&amp;Desktop colours</source>
        <translation>デスクトップと同じ配色(&amp;D)</translation>
    </message>
    <message>
        <source>Light or dark, following the desktop</source>
        <translation>明るい配色か暗い配色かをデスクトップに合わせます</translation>
    </message>
    <message>
        <source>&amp;Light colours</source>
        <translation>明るい配色(&amp;L)</translation>
    </message>
    <message>
        <source>Always light</source>
        <translation>いつも明るい配色にします</translation>
    </message>
    <message>
        <source>Dar&amp;k colours</source>
        <translation>暗い配色(&amp;K)</translation>
    </message>
    <message>
        <source>Always dark</source>
        <translation>いつも暗い配色にします</translation>
    </message>
    <message>
        <source>Des&amp;ktop language</source>
        <translation>デスクトップと同じ言語(&amp;K)</translation>
    </message>
    <message>
        <source>Use the language of the desktop</source>
        <translation>デスクトップの言語に合わせます</translation>
    </message>
    <message>
        <source>&amp;Larger text</source>
        <translation>文字を大きく(&amp;L)</translation>
    </message>
    <message>
        <source>Make the text larger</source>
        <translation>文字を大きくします</translation>
    </message>
    <message>
        <source>S&amp;maller text</source>
        <translation>文字を小さく(&amp;M)</translation>
    </message>
    <message>
        <source>Make the text smaller</source>
        <translation>文字を小さくします</translation>
    </message>
    <message>
        <source>Defa&amp;ult text size</source>
        <translation>標準の文字サイズ(&amp;U)</translation>
    </message>
    <message>
        <source>Reset the text size</source>
        <translation>文字を標準の大きさに戻します</translation>
    </message>
    <message>
        <source>&amp;Reduce motion</source>
        <translation>動きを減らす(&amp;R)</translation>
    </message>
    <message>
        <source>Le&amp;ft-handed</source>
        <translation>左利き(&amp;F)</translation>
    </message>
    <message>
        <source>Panels, the next button, brush and light change sides</source>
        <translation>パネル、次へ進むボタン、筆、光の左右を入れ替えます</translation>
    </message>
    <message>
        <source>No animations: changes appear at once</source>
        <translation>アニメーションを使わず、すぐに切り替えます</translation>
    </message>
    <message>
        <source>Me&amp;nus</source>
        <translation>メニュー(&amp;N)</translation>
    </message>
    <message>
        <source>Open the first menu; the arrow keys go on</source>
        <translation>最初のメニューを開きます。矢印キーで移ります</translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation>全画面(&amp;F)</translation>
    </message>
    <message>
        <source>Show only the tablet</source>
        <translation>文字板だけを表示します</translation>
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
        <source>Look at the tablet at an angle</source>
        <translation>文字板を斜めから見ます</translation>
    </message>
    <message>
        <source>Tilt back</source>
        <translation>起こす</translation>
    </message>
    <message>
        <source>Look more from above</source>
        <translation>文字板を上から見ます</translation>
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
        <source>Zoom in</source>
        <translation>拡大</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>縮小</translation>
    </message>
    <message>
        <source>Re&amp;set view</source>
        <translation>正面に戻す(&amp;S)</translation>
    </message>
    <message>
        <source>Show the whole tablet from straight above</source>
        <translation>文字板全体を正面から見ます</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation>ショートカットキー(&amp;K)</translation>
    </message>
    <message>
        <source>All keyboard shortcuts and mouse actions</source>
        <translation>すべてのショートカットキーとマウスの操作</translation>
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
        <source>&amp;Record pen motion</source>
        <translation>ペンの動きを記録(&amp;R)</translation>
    </message>
    <message>
        <source>Save every position and force of the pen to a file</source>
        <translation>ペンの位置と力をすべてファイルに記録します</translation>
    </message>
    <message>
        <source>Groove s&amp;ound</source>
        <translation>溝の音(&amp;O)</translation>
    </message>
    <message>
        <source>Play the sound of the stylus in the groove</source>
        <translation>ペン先が溝をこする音を鳴らします</translation>
    </message>
    <message>
        <source>Lo&amp;uder</source>
        <translation>音を大きく(&amp;U)</translation>
    </message>
    <message>
        <source>Make the groove sound louder</source>
        <translation>溝の音を大きくします</translation>
    </message>
    <message>
        <source>Quie&amp;ter</source>
        <translation>音を小さく(&amp;T)</translation>
    </message>
    <message>
        <source>Make the groove sound quieter</source>
        <translation>溝の音を小さくします</translation>
    </message>
    <message>
        <source>Feel s&amp;lopes with the mouse</source>
        <translation>マウスで溝の傾きを感じる(&amp;L)</translation>
    </message>
    <message>
        <source>The pointer moves more slowly uphill and faster downhill, as if held in the groove</source>
        <translation>ポインターが上り坂で遅く、下り坂で速くなり、溝に留まるように感じられます</translation>
    </message>
    <message>
        <source>More</source>
        <translation>その他</translation>
    </message>
    <message>
        <source>&amp;Print a worksheet…</source>
        <translation>プリントを作る(&amp;P)…</translation>
    </message>
    <message>
        <source>Practice sheets, quizzes, flash cards and manuscript paper as PDF</source>
        <translation>練習プリント、小テスト、カード、原稿用紙を PDF で作ります</translation>
    </message>
    <message>
        <source>&amp;Check worksheets…</source>
        <translation>プリントを判定(&amp;C)…</translation>
    </message>
    <message>
        <source>Read printed worksheets back from photographs: what is legible, and what needs care</source>
        <translation>印刷したプリントの写真を読み取り、読める字と直したい字を示します</translation>
    </message>
</context>
<context>
    <name>nazori::ui::AdviceWords</name>
    <message>
        <source>Stroke %1</source>
        <translation>%1画目</translation>
    </message>
    <message>
        <source>Strokes %1 and %2</source>
        <translation>%1・%2画目</translation>
    </message>
    <message>
        <source>, </source>
        <translation>・</translation>
    </message>
    <message>
        <source>%1: the start is turned by %2°. Begin in the direction of the arrow.</source>
        <translation>%1：書き始めの角度が%2°ずれています。矢印の向きに書き始めましょう。</translation>
    </message>
    <message>
        <source>%1: the start moves back first (hidden tip). Here the tip may stay visible.</source>
        <translation>%1：書き始めで穂先が一度戻っています（蔵鋒）。ここでは穂先を見せたまま書き始めてかまいません。</translation>
    </message>
    <message>
        <source>%1: the end stays broad. Lift the brush slowly while it is still moving.</source>
        <translation>%1：はらいの先が太いままです。筆を動かしながら少しずつ上げましょう。</translation>
    </message>
    <message>
        <source>%1: hurried at the beginning. Keep an even speed.</source>
        <translation>%1：始めを急いでいます。一定の速さで書きましょう。</translation>
    </message>
    <message>
        <source>%1: hurried in the middle. Keep an even speed.</source>
        <translation>%1：途中を急いでいます。一定の速さで書きましょう。</translation>
    </message>
    <message>
        <source>%1: hurried towards the end. Keep an even speed.</source>
        <translation>%1：終わりのほうを急いでいます。一定の速さで書きましょう。</translation>
    </message>
    <message>
        <source>%1: hesitant at the beginning. Keep an even speed.</source>
        <translation>%1：始めで筆が滞っています。一定の速さで書きましょう。</translation>
    </message>
    <message>
        <source>%1: hesitant in the middle. Keep an even speed.</source>
        <translation>%1：途中で筆が滞っています。一定の速さで書きましょう。</translation>
    </message>
    <message>
        <source>%1: hesitant towards the end. Keep an even speed.</source>
        <translation>%1：終わりのほうで筆が滞っています。一定の速さで書きましょう。</translation>
    </message>
    <message>
        <source>All strokes are equally thick. Press at starts and stops, and lift in hooks and sweeps.</source>
        <translation>線の太さに変化がありません。書き始めととめではおさえ、はねとはらいでは力を抜きましょう。</translation>
    </message>
    <message>
        <source>The ink covers only %1% of the model.</source>
        <translation>墨が手本の%1%にしか重なっていません。</translation>
    </message>
    <message>
        <source>%1% of the ink is outside the model.</source>
        <translation>墨の%1%が手本からはみ出しています。</translation>
    </message>
    <message>
        <source>The character is too far to the left.</source>
        <translation>字が左に寄っています。</translation>
    </message>
    <message>
        <source>The character is too far to the right.</source>
        <translation>字が右に寄っています。</translation>
    </message>
    <message>
        <source>The character is too high.</source>
        <translation>字が上に寄っています。</translation>
    </message>
    <message>
        <source>The character is too low.</source>
        <translation>字が下に寄っています。</translation>
    </message>
    <message>
        <source>The character is larger than the model.</source>
        <translation>字が手本より大きすぎます。</translation>
    </message>
    <message>
        <source>The character is smaller than the model.</source>
        <translation>字が手本より小さすぎます。</translation>
    </message>
    <message>
        <source>The gap between strokes %1 and %2 is too wide.</source>
        <translation>%1画目と%2画目の間が広すぎます。</translation>
    </message>
    <message>
        <source>The gap between strokes %1 and %2 is too narrow.</source>
        <translation>%1画目と%2画目の間が狭すぎます。</translation>
    </message>
    <message>
        <source>Too few strokes match the model, so they cannot be compared.</source>
        <translation>手本と合う画が少ないため、比べられません。</translation>
    </message>
    <message>
        <source>Well written: there is nothing to correct.</source>
        <translation>よく書けています。直すところはありません。</translation>
    </message>
    <message>
        <source>%1: very good.</source>
        <translation>%1：たいへんよく書けています。</translation>
    </message>
    <message>
        <source>%1:</source>
        <translation>%1：</translation>
    </message>
    <message>
        <source>%1: there is no stop. Stop and press at the end, then lift.</source>
        <translation>%1：とめがありません。終わりで止め、おさえてから筆を上げましょう。</translation>
    </message>
    <message>
        <source>%1: the hook is missing or blunt. Stop, then flick the brush off.</source>
        <translation>%1：はねがないか、はっきりしません。一度止めてからはねましょう。</translation>
    </message>
    <message>
        <source>%1: too thin. Press more, or take a thicker brush.</source>
        <translation>%1：線が細すぎます。もっと筆をおさえるか、太い筆を使いましょう。</translation>
    </message>
    <message>
        <source>%1: too thick. Press less, or take a thinner brush.</source>
        <translation>%1：線が太すぎます。力を抜くか、細い筆を使いましょう。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::AnkiDialog</name>
    <message>
        <source>Export for Anki</source>
        <translation>Anki 用に書き出す</translation>
    </message>
    <message>
        <source>Choose file…</source>
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
        <source>&amp;Words per character</source>
        <translation>1字あたりの言葉の数(&amp;W)</translation>
    </message>
</context>
<context>
    <name>nazori::ui::BackupsDialog</name>
    <message>
        <source>Daily</source>
        <translation>毎日の自動保存</translation>
    </message>
    <message>
        <source>Made by you</source>
        <translation>自分で作成</translation>
    </message>
    <message>
        <source>Saved before a restore</source>
        <translation>復元前の自動保存</translation>
    </message>
    <message>
        <source>Saved before an update</source>
        <translation>更新前の自動保存</translation>
    </message>
    <message>
        <source>Backups of %1</source>
        <translation>%1 のバックアップ</translation>
    </message>
    <message>
        <source>Backups, newest first</source>
        <translation>バックアップ（新しい順）</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>種類</translation>
    </message>
    <message>
        <source>Last study day</source>
        <translation>最後の学習日</translation>
    </message>
    <message>
        <source>Times written</source>
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
        <source>&amp;Restore…</source>
        <translation>復元(&amp;R)…</translation>
    </message>
    <message>
        <source>No backups yet. Your data is backed up automatically on every study day.</source>
        <translation>バックアップはまだありません。学習した日ごとに自動でバックアップされます。</translation>
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
        <source>%1, last study day %2, times written: %3, characters: %4</source>
        <translation>%1、最後の学習日：%2、書いた回数：%3、文字数：%4</translation>
    </message>
    <message>
        <source>Restore from a backup</source>
        <translation>バックアップから復元</translation>
    </message>
    <message>
        <source>Replace the study data of %1 with this backup? %2</source>
        <translation>%1 の学習データを、このバックアップに置き換えますか。%2</translation>
    </message>
    <message>
        <source>Your current data is backed up first, so you can undo this.</source>
        <translation>今のデータは先にバックアップされるので、元に戻せます。</translation>
    </message>
    <message>
        <source>&amp;Restore</source>
        <translation>復元(&amp;R)</translation>
    </message>
    <message>
        <source>Daily (%1)</source>
        <translation>毎日の自動保存（%1）</translation>
    </message>
</context>
<context>
    <name>nazori::ui::BrushActions</name>
    <message>
        <source>&amp;Ink</source>
        <translation>墨をつける(&amp;I)</translation>
    </message>
    <message>
        <source>Dip the brush in ink</source>
        <translation>筆に墨をつけます</translation>
    </message>
    <message>
        <source>&amp;Water</source>
        <translation>水をつける(&amp;W)</translation>
    </message>
    <message>
        <source>Dip the brush in water: the ink becomes paler</source>
        <translation>筆に水をつけて墨を薄めます</translation>
    </message>
    <message>
        <source>Wi&amp;pe</source>
        <translation>筆をふく(&amp;P)</translation>
    </message>
    <message>
        <source>Wipe the brush: it holds half as much ink</source>
        <translation>筆をふいて墨を半分に減らします</translation>
    </message>
    <message>
        <source>&amp;Thicker brush</source>
        <translation>太い筆(&amp;T)</translation>
    </message>
    <message>
        <source>Take the next thicker brush</source>
        <translation>1つ太い筆に替えます</translation>
    </message>
    <message>
        <source>T&amp;hinner brush</source>
        <translation>細い筆(&amp;H)</translation>
    </message>
    <message>
        <source>Take the next thinner brush</source>
        <translation>1つ細い筆に替えます</translation>
    </message>
    <message>
        <source>Other h&amp;air</source>
        <translation>毛を替える(&amp;A)</translation>
    </message>
    <message>
        <source>Take a brush with other hair: goat, mixed, weasel</source>
        <translation>羊毛・兼毫・イタチ毛の順に筆を替えます</translation>
    </message>
    <message>
        <source>Other ink &amp;colour</source>
        <translation>墨の色を替える(&amp;C)</translation>
    </message>
    <message>
        <source>Wash the brush and take the next ink</source>
        <translation>筆を洗って次の色の墨をつけます</translation>
    </message>
    <message>
        <source>&amp;Guess pressure</source>
        <translation>筆圧を推定する(&amp;G)</translation>
    </message>
    <message>
        <source>With mouse and finger: a slow stroke is thick, a fast one thin</source>
        <translation>マウスや指のとき、ゆっくり書くと太く、速く書くと細くなります</translation>
    </message>
    <message>
        <source>&amp;Left hand</source>
        <translation>左手で書く(&amp;L)</translation>
    </message>
    <message>
        <source>The brush leans to the left; the tilt of a pen is mirrored</source>
        <translation>筆が左に傾き、ペンの傾きも左右が逆になります</translation>
    </message>
    <message>
        <source>&amp;Strengthen the force</source>
        <translation>力を強める(&amp;S)</translation>
    </message>
    <message>
        <source>A force-feedback device pushes four times as hard as the brush</source>
        <translation>力覚デバイスが筆の4倍の力で押し返します</translation>
    </message>
    <message>
        <source>Show the &amp;brush</source>
        <translation>筆を表示する(&amp;B)</translation>
    </message>
    <message>
        <source>Show the brush above the paper</source>
        <translation>紙の上に筆を表示します</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>元に戻す(&amp;U)</translation>
    </message>
    <message>
        <source>Undo the last stroke</source>
        <translation>最後の画を取り消します</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>やり直す(&amp;R)</translation>
    </message>
    <message>
        <source>Redo what was undone</source>
        <translation>取り消した操作をやり直します</translation>
    </message>
    <message>
        <source>&amp;Dry now</source>
        <translation>すぐに乾かす(&amp;D)</translation>
    </message>
    <message>
        <source>Dry the sheet at once</source>
        <translation>紙をすぐに乾かします</translation>
    </message>
    <message>
        <source>&amp;New sheet</source>
        <translation>新しい紙(&amp;N)</translation>
    </message>
    <message>
        <source>Take an empty sheet; undo brings this one back</source>
        <translation>新しい紙に替えます。元に戻すと今の紙に戻ります</translation>
    </message>
    <message>
        <source>Other &amp;paper</source>
        <translation>紙の種類を替える(&amp;P)</translation>
    </message>
    <message>
        <source>Take a new sheet of the next kind of paper</source>
        <translation>次の種類の新しい紙に替えます</translation>
    </message>
    <message>
        <source>De&amp;scribe the sheet</source>
        <translation>紙の様子を説明する(&amp;S)</translation>
    </message>
    <message>
        <source>Say what is on the paper and in the brush</source>
        <translation>紙に書いたものと筆の墨を読み上げます</translation>
    </message>
    <message>
        <source>Save as a pictur&amp;e…</source>
        <translation>画像として保存(&amp;E)…</translation>
    </message>
    <message>
        <source>&amp;Carve as a tablet</source>
        <translation>文字板に彫る(&amp;C)</translation>
    </message>
    <message>
        <source>Carve the ink into a tablet that you can feel</source>
        <translation>書いた墨を溝に彫り、触れる文字板にします</translation>
    </message>
    <message>
        <source>&amp;Tools beside the paper</source>
        <translation>紙の横の道具(&amp;T)</translation>
    </message>
    <message>
        <source>Show or hide brush, paper and model</source>
        <translation>筆・紙・手本の欄を表示または隠します</translation>
    </message>
    <message>
        <source>&amp;No model</source>
        <translation>手本なし(&amp;N)</translation>
    </message>
    <message>
        <source>Write without a model</source>
        <translation>手本なしで書きます</translation>
    </message>
    <message>
        <source>Model &amp;beneath</source>
        <translation>手本を下に敷く(&amp;B)</translation>
    </message>
    <message>
        <source>Show the model faintly under the ink</source>
        <translation>墨の下に手本を薄く表示します</translation>
    </message>
    <message>
        <source>Model be&amp;side</source>
        <translation>手本を横に置く(&amp;S)</translation>
    </message>
    <message>
        <source>Show the model beside the paper</source>
        <translation>紙の横に手本を表示します</translation>
    </message>
    <message>
        <source>Other &amp;ruling</source>
        <translation>罫線を替える(&amp;R)</translation>
    </message>
    <message>
        <source>Rule the sheet for 0, 1, 2, 4 or 6 characters</source>
        <translation>紙の罫線を 0、1、2、4、6字用に替えます</translation>
    </message>
    <message>
        <source>Model &amp;text…</source>
        <translation>手本の文字(&amp;T)…</translation>
    </message>
    <message>
        <source>Type what you want to write</source>
        <translation>書きたい文字を入力します</translation>
    </message>
    <message>
        <source>Ne&amp;xt part</source>
        <translation>次のパーツ(&amp;X)</translation>
    </message>
    <message>
        <source>Show the next part of the model text</source>
        <translation>手本の文字の次のパーツを表示します</translation>
    </message>
    <message>
        <source>Pre&amp;vious part</source>
        <translation>前のパーツ(&amp;V)</translation>
    </message>
    <message>
        <source>Show the previous part of the model text</source>
        <translation>手本の文字の前のパーツを表示します</translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation>筆(&amp;B)</translation>
    </message>
    <message>
        <source>S&amp;heet</source>
        <translation>紙(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Model</source>
        <translation>手本(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Advice</source>
        <translation>助言(&amp;A)</translation>
    </message>
    <message>
        <source>Compare the sheet with the model: advice in words, and corrections in vermilion</source>
        <translation>書いた字を手本と比べ、言葉で助言し、朱で直します</translation>
    </message>
    <message>
        <source>Save the sheet as a picture (PNG) or a page (PDF), or its strokes (SVG)</source>
        <translation>紙を画像（PNG）やページ（PDF）で、画を SVG で保存します</translation>
    </message>
    <message>
        <source>Other f&amp;ont</source>
        <translation>ほかの書体(&amp;O)</translation>
    </message>
    <message>
        <source>Take the model from the next brush font, or as printed lines</source>
        <translation>手本を次の筆書体、または活字の線にします</translation>
    </message>
    <message>
        <source>&amp;Review with the brush</source>
        <translation>筆で復習する(&amp;R)</translation>
    </message>
    <message>
        <source>Write well known characters with the brush, as set in the study settings</source>
        <translation>定着した文字を筆で書きます。数は学習の設定で決めます</translation>
    </message>
    <message>
        <source>&amp;Next</source>
        <translation>次へ(&amp;N)</translation>
    </message>
    <message>
        <source>Get advice, or accept the suggested rating</source>
        <translation>助言を見る、またはおすすめの評価にします</translation>
    </message>
    <message>
        <source>&amp;Again</source>
        <translation>もう一度(&amp;A)</translation>
    </message>
    <message>
        <source>Not yet: comes back soon</source>
        <translation>まだ書けない：近いうちにまた出ます</translation>
    </message>
    <message>
        <source>&amp;Hard</source>
        <translation>難しい(&amp;H)</translation>
    </message>
    <message>
        <source>Written with effort</source>
        <translation>苦労して書けた</translation>
    </message>
    <message>
        <source>Goo&amp;d</source>
        <translation>できた(&amp;D)</translation>
    </message>
    <message>
        <source>Written well</source>
        <translation>よく書けた</translation>
    </message>
    <message>
        <source>&amp;Easy</source>
        <translation>簡単(&amp;E)</translation>
    </message>
    <message>
        <source>Written well and easily</source>
        <translation>楽によく書けた</translation>
    </message>
    <message>
        <source>S&amp;kip</source>
        <translation>スキップ(&amp;K)</translation>
    </message>
    <message>
        <source>Leave this character out of this session; it stays due</source>
        <translation>この文字を今回は飛ばします。復習には残ります</translation>
    </message>
    <message>
        <source>Undo las&amp;t review</source>
        <translation>最後の復習を取り消す(&amp;T)</translation>
    </message>
    <message>
        <source>Undo the last saved review or change; repeat to go further back</source>
        <translation>最後に保存した復習や変更を取り消します。繰り返すとさらに前に戻ります</translation>
    </message>
    <message>
        <source>End the &amp;session</source>
        <translation>学習を終える(&amp;S)</translation>
    </message>
    <message>
        <source>Everything you rated is saved</source>
        <translation>評価したものは保存されています</translation>
    </message>
    <message>
        <source>St&amp;udy</source>
        <translation>学習(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Watch it written</source>
        <translation>書くところを見る(&amp;W)</translation>
    </message>
    <message>
        <source>The brush writes the model by itself, as a teacher shows it; again: stop</source>
        <translation>先生のように、筆が手本を書いて見せます。もう一度押すと止まります</translation>
    </message>
    <message>
        <source>&amp;Move the brush by key</source>
        <translation>キーで筆を動かす(&amp;M)</translation>
    </message>
    <message>
        <source>Write with the arrow keys or the number pad; Shift: fine steps</source>
        <translation>矢印キーかテンキーで書きます。Shift：細かく動かす</translation>
    </message>
    <message>
        <source>Brush &amp;up or down</source>
        <translation>筆を下ろす／上げる(&amp;U)</translation>
    </message>
    <message>
        <source>Put the brush on the paper, or lift it</source>
        <translation>筆を紙に下ろします。もう一度押すと上げます</translation>
    </message>
    <message>
        <source>To the next &amp;start</source>
        <translation>次の書き始めへ(&amp;S)</translation>
    </message>
    <message>
        <source>Go to the start of the next stroke of the model</source>
        <translation>手本の次の画の書き始めへ移ります</translation>
    </message>
    <message>
        <source>&amp;Where is the brush?</source>
        <translation>筆の場所(&amp;W)</translation>
    </message>
    <message>
        <source>Say where the brush is</source>
        <translation>筆がどこにあるかを知らせます</translation>
    </message>
    <message>
        <source>Press &amp;harder</source>
        <translation>強く押す(&amp;H)</translation>
    </message>
    <message>
        <source>Move by key: press the brush harder</source>
        <translation>キーで動かすとき、筆を強く押します</translation>
    </message>
    <message>
        <source>Press s&amp;ofter</source>
        <translation>弱く押す(&amp;O)</translation>
    </message>
    <message>
        <source>Move by key: press the brush less</source>
        <translation>キーで動かすとき、筆を弱く押します</translation>
    </message>
    <message>
        <source>By &amp;key</source>
        <translation>キーで書く(&amp;K)</translation>
    </message>
</context>
<context>
    <name>nazori::ui::BrushPage</name>
    <message>
        <source>Dipped in ink.</source>
        <translation>墨をつけました。</translation>
    </message>
    <message>
        <source>Dipped in water: the ink is paler.</source>
        <translation>水をつけました。墨が薄くなりました。</translation>
    </message>
    <message>
        <source>Wiped: half of the ink is gone.</source>
        <translation>筆をふきました。墨が半分になりました。</translation>
    </message>
    <message>
        <source>Brush: %1, %2.</source>
        <translation>筆：%1、%2。</translation>
    </message>
    <message>
        <source>The whole model text is on this sheet.</source>
        <translation>手本の文字はすべてこの紙にあります。</translation>
    </message>
    <message>
        <source>Could not open %1: %2. The sheet was not changed.</source>
        <translation>%1 を開けませんでした：%2。紙は変わっていません。</translation>
    </message>
    <message>
        <source>Could not save %1: %2.</source>
        <translation>%1 を保存できませんでした：%2。</translation>
    </message>
    <message>
        <source>The sheet is still wet with other inks. D: dry it now.</source>
        <translation>紙がほかの色の墨でまだぬれています。D：すぐに乾かす。</translation>
    </message>
    <message>
        <source>This is not possible: %1.</source>
        <translation>実行できません：%1。</translation>
    </message>
    <message>
        <source>The sheet is dry.</source>
        <translation>紙が乾きました。</translation>
    </message>
    <message>
        <source>The sheet was dry already.</source>
        <translation>紙はすでに乾いています。</translation>
    </message>
    <message>
        <source>New sheet: %1. %2 brings the old one back.</source>
        <translation>新しい紙：%1。%2 で前の紙に戻ります。</translation>
    </message>
    <message>
        <source>Ink: %1.</source>
        <translation>墨：%1。</translation>
    </message>
    <message>
        <source>Opened %1.</source>
        <translation>%1 を開きました。</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 を保存しました。</translation>
    </message>
    <message>
        <source>Brush sheet</source>
        <translation>筆で書いた紙</translation>
    </message>
    <message>
        <source>Open a sheet</source>
        <translation>紙を開く</translation>
    </message>
    <message>
        <source>Sheet of paper (*.nzs)</source>
        <translation>紙 (*.nzs)</translation>
    </message>
    <message>
        <source>Save as</source>
        <translation>名前を付けて保存</translation>
    </message>
    <message>
        <source>Picture (*.png)</source>
        <translation>画像 (*.png)</translation>
    </message>
    <message>
        <source>The sheet with your brush writing is not saved.</source>
        <translation>筆で書いた紙はまだ保存されていません。</translation>
    </message>
    <message>
        <source>&amp;Brush</source>
        <translation>筆(&amp;B)</translation>
    </message>
    <message>
        <source>Write with brush and ink on paper</source>
        <translation>筆と墨で紙に書きます</translation>
    </message>
    <message>
        <source>The brush is almost dry. I: dip it in ink.</source>
        <translation>筆の墨が残りわずかです。I：墨をつける。</translation>
    </message>
    <message>
        <source>No model.</source>
        <translation>手本なし。</translation>
    </message>
    <message>
        <source>Model beneath: %1.</source>
        <translation>下の手本：%1。</translation>
    </message>
    <message>
        <source>Model beside: %1.</source>
        <translation>横の手本：%1。</translation>
    </message>
    <message>
        <source>Part %1 of %2.</source>
        <translation>全%2枚の%1枚目。</translation>
    </message>
    <message>
        <source>Write a character first. Then J gives advice.</source>
        <translation>先に字を書いてください。その後 J で助言します。</translation>
    </message>
    <message>
        <source>There are no strokes in the squares of the model.</source>
        <translation>手本のます目に画がありません。</translation>
    </message>
    <message>
        <source>Advice: %1</source>
        <translation>助言：%1</translation>
    </message>
    <message>
        <source>The corrections are gone.</source>
        <translation>朱の直しを消しました。</translation>
    </message>
    <message>
        <source>Strokes (*.svg)</source>
        <translation>画 (*.svg)</translation>
    </message>
    <message>
        <source>Page at real size (*.pdf)</source>
        <translation>実寸のページ (*.pdf)</translation>
    </message>
    <message>
        <source>The font %1 is not installed: the model has printed lines.</source>
        <translation>書体「%1」が入っていません。手本は活字の線になります。</translation>
    </message>
    <message>
        <source>%1 has printed lines: %2 does not have it with the same strokes.</source>
        <translation>%1は活字の線です。%2には同じ画のこの文字がありません。</translation>
    </message>
    <message>
        <source>Model: %1.</source>
        <translation>手本：%1。</translation>
    </message>
    <message>
        <source>Font: %1.</source>
        <translation>書体：%1。</translation>
    </message>
    <message>
        <source>Reviews with the brush are off. Choose how many you want a day at Home, in Study settings, Daily goal.</source>
        <translation>筆での復習はオフです。1日の数は、ホームの「学習の設定」の「1日の目標」で選べます。</translation>
    </message>
    <message>
        <source>Pressure: %1%.</source>
        <translation>筆圧：%1%。</translation>
    </message>
    <message>
        <source>The brush cannot be pressed harder.</source>
        <translation>これ以上強く押せません。</translation>
    </message>
    <message>
        <source>The brush cannot be pressed more softly.</source>
        <translation>これ以上弱く押せません。</translation>
    </message>
    <message>
        <source>Lower the stylus onto the sheet: you feel the brush. A button of the stylus, or I: ink. S: what is on the sheet.</source>
        <translation>ペンを紙に下ろすと、筆の手ごたえがあります。ペンのボタンまたは I：墨、S：紙の説明。</translation>
    </message>
    <message>
        <source>Write on the sheet with mouse, pen or finger, or by keys (M). I: ink. W: water. S: what is on the sheet.</source>
        <translation>マウス、ペン、指、またはキー（M）で紙に書いてください。I：墨、W：水、S：紙の説明。</translation>
    </message>
    <message>
        <source>The device pushes four times as hard as the brush.</source>
        <translation>デバイスは筆の4倍の力で押し返します。</translation>
    </message>
    <message>
        <source>The device pushes as hard as the brush.</source>
        <translation>デバイスは筆と同じ力で押し返します。</translation>
    </message>
    <message>
        <source>Stopped.</source>
        <translation>止めました。</translation>
    </message>
    <message>
        <source>There is no model to be written. T: type a text.</source>
        <translation>書いて見せる手本がありません。T：手本の字を入力</translation>
    </message>
    <message numerus="yes">
        <source>Hold the stylus loosely: it leads your hand through %n strokes. V: stop.</source>
        <translation>
            <numerusform>ペンを軽く持ってください。%n画を、手を導いて書きます。V：止める</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Watch: %n strokes. V: stop.</source>
        <translation>
            <numerusform>ご覧ください。全部で%n画です。V：止める</numerusform>
        </translation>
    </message>
    <message>
        <source>That is how it is written. Ctrl+N: a new sheet for you.</source>
        <translation>このように書きます。Ctrl+N：新しい紙で書いてみる</translation>
    </message>
</context>
<context>
    <name>nazori::ui::BrushReviewBar</name>
    <message>
        <source>Review with the brush</source>
        <translation>筆での復習</translation>
    </message>
    <message>
        <source>Advice  ⏎</source>
        <translation>助言  ⏎</translation>
    </message>
    <message>
        <source>Advice</source>
        <translation>助言</translation>
    </message>
    <message numerus="yes">
        <source>a character with %n strokes</source>
        <translation>
            <numerusform>%n画の文字</numerusform>
        </translation>
    </message>
    <message>
        <source>With the brush · %1 of %2</source>
        <translation>筆で · %2字中%1字目</translation>
    </message>
    <message>
        <source>%1: %2, suggested</source>
        <translation>%1：%2、おすすめ</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>The advice is not a mark: you rate your writing. Suggested: %1.</source>
        <translation>助言は採点ではありません。評価はあなたがつけます。おすすめ：%1。</translation>
    </message>
    <message>
        <source>Not all strokes are those of the character. The advice is not a mark: you rate your writing. Suggested: %1.</source>
        <translation>この文字と違う画があります。助言は採点ではありません。評価はあなたがつけます。おすすめ：%1。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::BrushToolsPanel</name>
    <message>
        <source>Ink in the brush</source>
        <translation>筆の墨</translation>
    </message>
    <message>
        <source>Brush, paper and model</source>
        <translation>筆・紙・手本</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>筆</translation>
    </message>
    <message>
        <source>Ink</source>
        <translation>墨</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>太さ</translation>
    </message>
    <message>
        <source>Hair</source>
        <translation>毛</translation>
    </message>
    <message>
        <source>Paper</source>
        <translation>紙</translation>
    </message>
    <message>
        <source>Ruling</source>
        <translation>罫線</translation>
    </message>
    <message>
        <source>Model</source>
        <translation>手本</translation>
    </message>
    <message>
        <source>Place</source>
        <translation>位置</translation>
    </message>
    <message>
        <source>None</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Beneath</source>
        <translation>下に敷く</translation>
    </message>
    <message>
        <source>Beside</source>
        <translation>横に置く</translation>
    </message>
    <message>
        <source>Text of the model</source>
        <translation>手本の文字</translation>
    </message>
    <message>
        <source>Current character</source>
        <translation>今の字</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>Advice (not a mark)</source>
        <translation>助言（採点ではありません）</translation>
    </message>
    <message>
        <source>Font</source>
        <translation>フォント</translation>
    </message>
</context>
<context>
    <name>nazori::ui::BrushWords</name>
    <message>
        <source>Nothing is written yet.</source>
        <translation>まだ何も書いていません。</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes</source>
        <translation>
            <numerusform>%n画</numerusform>
        </translation>
    </message>
    <message>
        <source>Hanshi (practice paper)</source>
        <translation>半紙（練習用）</translation>
    </message>
    <message>
        <source>Gasenshi (bleeds fast)</source>
        <translation>画仙紙（にじみが速い）</translation>
    </message>
    <message>
        <source>Gasenshi (bleeds slowly)</source>
        <translation>画仙紙（ゆっくりにじむ）</translation>
    </message>
    <message>
        <source>Board (hardly bleeds)</source>
        <translation>色紙（ほとんどにじまない）</translation>
    </message>
    <message>
        <source>Water paper (fades as it dries)</source>
        <translation>水書き用紙（乾くと消える）</translation>
    </message>
    <message>
        <source>Sumi, black</source>
        <translation>墨（黒）</translation>
    </message>
    <message>
        <source>Sumi, bluish</source>
        <translation>青墨</translation>
    </message>
    <message>
        <source>Sumi, brownish</source>
        <translation>茶墨</translation>
    </message>
    <message>
        <source>Vermilion</source>
        <translation>朱墨</translation>
    </message>
    <message>
        <source>Water only</source>
        <translation>水だけ</translation>
    </message>
    <message>
        <source>Goat (soft)</source>
        <translation>羊毛（やわらかい）</translation>
    </message>
    <message>
        <source>Mixed</source>
        <translation>兼毫（ふつう）</translation>
    </message>
    <message>
        <source>Weasel (stiff)</source>
        <translation>イタチ毛（かたい）</translation>
    </message>
    <message>
        <source>Large</source>
        <translation>大筆</translation>
    </message>
    <message>
        <source>Medium</source>
        <translation>中筆</translation>
    </message>
    <message>
        <source>Small</source>
        <translation>小筆</translation>
    </message>
    <message>
        <source>Fine</source>
        <translation>細筆</translation>
    </message>
    <message>
        <source>No ruling</source>
        <translation>罫線なし</translation>
    </message>
    <message numerus="yes">
        <source>%n characters</source>
        <translation>
            <numerusform>%n字</numerusform>
        </translation>
    </message>
    <message>
        <source>The brush is empty.</source>
        <translation>筆に墨がありません。</translation>
    </message>
    <message>
        <source>Brush: %1% full, water only.</source>
        <translation>筆：水だけ %1%。</translation>
    </message>
    <message>
        <source>Brush: %1% full, ink %2%.</source>
        <translation>筆：含み %1%、濃さ %2%。</translation>
    </message>
    <message>
        <source>%1, wet.</source>
        <translation>%1、ぬれています。</translation>
    </message>
    <message>
        <source>%1, dry.</source>
        <translation>%1、乾いています。</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>元に戻す操作がありません。</translation>
    </message>
    <message>
        <source>Stroke %1 undone.</source>
        <translation>%1画目を取り消しました。</translation>
    </message>
    <message>
        <source>Drying undone: the sheet is wet again.</source>
        <translation>乾かす前に戻しました。紙はぬれています。</translation>
    </message>
    <message>
        <source>The sheet before is back: %1.</source>
        <translation>前の紙に戻りました：%1。</translation>
    </message>
    <message>
        <source>There is nothing to redo.</source>
        <translation>やり直す操作がありません。</translation>
    </message>
    <message>
        <source>Stroke %1 redone.</source>
        <translation>%1画目をやり直しました。</translation>
    </message>
    <message>
        <source>The sheet is dry again.</source>
        <translation>紙がまた乾きました。</translation>
    </message>
    <message>
        <source>The next sheet is back: %1.</source>
        <translation>次の紙に進みました：%1。</translation>
    </message>
    <message>
        <source>Printed lines</source>
        <translation>活字の線</translation>
    </message>
    <message>
        <source>For more fonts, install %1 and start Nazori again.</source>
        <translation>ほかの書体を使うには、%1 を入れてから Nazori を起動し直してください。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::CalendarCard</name>
    <message>
        <source>Earlier year</source>
        <translation>前の年</translation>
    </message>
    <message>
        <source>Later year</source>
        <translation>次の年</translation>
    </message>
    <message>
        <source>Earlier year (Page Up)</source>
        <translation>前の年（Page Up）</translation>
    </message>
    <message>
        <source>Later year (Page Down)</source>
        <translation>次の年（Page Down）</translation>
    </message>
    <message>
        <source>Calendar</source>
        <translation>学習カレンダー</translation>
    </message>
    <message>
        <source>Study days in %1: %2. Darker squares: written or practised more often.</source>
        <translation>%1年の学習日数：%2日。色が濃いほど、書いたり練習したりした回数の多い日です。</translation>
    </message>
    <message>
        <source>Day</source>
        <translation>日</translation>
    </message>
    <message>
        <source>From memory</source>
        <translation>見ないで書いた回数</translation>
    </message>
    <message>
        <source>Practised</source>
        <translation>練習した回数</translation>
    </message>
    <message>
        <source>New</source>
        <translation>新しい字</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>時間</translation>
    </message>
    <message>
        <source>Calendar of %1. Arrow keys: day by day and week by week. Levels: %2.</source>
        <translation>%1年の学習カレンダー。矢印キーで1日ずつ、1週間ずつ移ります。色の段階：%2回。</translation>
    </message>
    <message>
        <source>, </source>
        <translation>、</translation>
    </message>
</context>
<context>
    <name>nazori::ui::CharacterActions</name>
    <message>
        <source>Pen by &amp;keys</source>
        <translation>キーで動かすペン(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Move the pen by key</source>
        <translation>キーでペンを動かす(&amp;M)</translation>
    </message>
    <message>
        <source>Explore and write with the arrow keys or the number pad; Shift: fine steps</source>
        <translation>矢印キーかテンキーで字をたどり、書きます。Shift：細かく動かす</translation>
    </message>
    <message>
        <source>Pen &amp;down or up</source>
        <translation>ペンを下ろす／上げる(&amp;D)</translation>
    </message>
    <message>
        <source>Put the pen down, or lift it</source>
        <translation>ペンを下ろします。もう一度押すと上げます</translation>
    </message>
    <message>
        <source>To the next &amp;start</source>
        <translation>次の書き始めへ(&amp;S)</translation>
    </message>
    <message>
        <source>Go to the start of the next stroke</source>
        <translation>次の画の書き始めへ動かします</translation>
    </message>
    <message>
        <source>&amp;Where is the pen?</source>
        <translation>ペンの場所(&amp;W)</translation>
    </message>
    <message>
        <source>Say where the pen is</source>
        <translation>ペンがどこにあるかを知らせます</translation>
    </message>
    <message>
        <source>&amp;More lenient</source>
        <translation>もう少しやさしく(&amp;M)</translation>
    </message>
    <message>
        <source>Check a little more leniently</source>
        <translation>少しやさしく判定します</translation>
    </message>
    <message>
        <source>More str&amp;ict</source>
        <translation>もう少しきびしく(&amp;I)</translation>
    </message>
    <message>
        <source>Check a little more strictly</source>
        <translation>少しきびしく判定します</translation>
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
        <translation>一覧の次の文字(&amp;N)</translation>
    </message>
    <message>
        <source>Go to the next character in the list</source>
        <translation>一覧の次の文字へ移ります</translation>
    </message>
    <message>
        <source>&amp;Previous in the list</source>
        <translation>一覧の前の文字(&amp;P)</translation>
    </message>
    <message>
        <source>Go to the previous character in the list</source>
        <translation>一覧の前の文字へ移ります</translation>
    </message>
    <message>
        <source>&amp;Back</source>
        <translation>戻る(&amp;B)</translation>
    </message>
    <message>
        <source>Go back to the character you viewed before</source>
        <translation>直前に見た文字へ戻ります</translation>
    </message>
    <message>
        <source>For&amp;ward</source>
        <translation>進む(&amp;W)</translation>
    </message>
    <message>
        <source>Go forward again to the character you came back from</source>
        <translation>戻る前の文字へ進みます</translation>
    </message>
    <message>
        <source>&amp;Next stroke</source>
        <translation>次の画(&amp;N)</translation>
    </message>
    <message>
        <source>Show only the next stroke; after the last one, show all</source>
        <translation>次の画だけを表示します。最後の画の次はすべて表示します</translation>
    </message>
    <message>
        <source>&amp;Previous stroke</source>
        <translation>前の画(&amp;P)</translation>
    </message>
    <message>
        <source>Show only the previous stroke; before the first one, show all</source>
        <translation>前の画だけを表示します。最初の画の前はすべて表示します</translation>
    </message>
    <message>
        <source>&amp;All strokes</source>
        <translation>すべての画(&amp;A)</translation>
    </message>
    <message>
        <source>Show all strokes at once</source>
        <translation>すべての画を表示します</translation>
    </message>
    <message>
        <source>&amp;Strokes</source>
        <translation>画(&amp;S)</translation>
    </message>
    <message>
        <source>Show or hide the strokes</source>
        <translation>画を表示／非表示にします</translation>
    </message>
    <message>
        <source>N&amp;umbers</source>
        <translation>番号(&amp;U)</translation>
    </message>
    <message>
        <source>Show or hide the number at each stroke&apos;s start</source>
        <translation>書き始めの番号を表示／非表示にします</translation>
    </message>
    <message>
        <source>A&amp;rrows</source>
        <translation>矢印(&amp;R)</translation>
    </message>
    <message>
        <source>Show or hide the arrowheads</source>
        <translation>矢印を表示／非表示にします</translation>
    </message>
    <message>
        <source>S&amp;nap</source>
        <translation>引き寄せ(&amp;N)</translation>
    </message>
    <message>
        <source>Strokes attract the stylus while they are visible</source>
        <translation>見えている画がペン先を引き寄せます</translation>
    </message>
    <message>
        <source>&amp;Clear ink</source>
        <translation>書いた線を消す(&amp;C)</translation>
    </message>
    <message>
        <source>Clear the tablet so that you can write again</source>
        <translation>書いた線を消し、もう一度書けるようにします</translation>
    </message>
    <message>
        <source>&amp;Character</source>
        <translation>文字(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Draw to find</source>
        <translation>手書きで探す(&amp;D)</translation>
    </message>
    <message>
        <source>Find a character by drawing it</source>
        <translation>文字を手書きして探します</translation>
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
        <translation>ガイド付きで書く(&amp;G)</translation>
    </message>
    <message>
        <source>Write with only the groove or the starting points as a guide; strokes attract the stylus</source>
        <translation>溝だけ、または書き始めだけを頼りに書きます。画がペン先を引き寄せます</translation>
    </message>
    <message>
        <source>&amp;Memory</source>
        <translation>見ないで書く(&amp;M)</translation>
    </message>
    <message>
        <source>Write on a blank tablet and have your writing checked</source>
        <translation>何もない文字板に書き、判定を受けます</translation>
    </message>
    <message>
        <source>&amp;Play</source>
        <translation>再生(&amp;P)</translation>
    </message>
    <message>
        <source>Play or pause</source>
        <translation>再生または一時停止します</translation>
    </message>
    <message>
        <source>One stroke &amp;back</source>
        <translation>一画戻る(&amp;B)</translation>
    </message>
    <message>
        <source>Go back to the start of the stroke</source>
        <translation>画の始まりに戻ります</translation>
    </message>
    <message>
        <source>One stroke f&amp;orward</source>
        <translation>一画進む(&amp;O)</translation>
    </message>
    <message>
        <source>Go forward to the end of the stroke</source>
        <translation>画の終わりに進みます</translation>
    </message>
    <message>
        <source>&amp;Slower</source>
        <translation>遅く(&amp;S)</translation>
    </message>
    <message>
        <source>Play more slowly</source>
        <translation>遅くします</translation>
    </message>
    <message>
        <source>&amp;Faster</source>
        <translation>速く(&amp;F)</translation>
    </message>
    <message>
        <source>Play faster</source>
        <translation>速くします</translation>
    </message>
    <message>
        <source>&amp;Loop</source>
        <translation>繰り返す(&amp;L)</translation>
    </message>
    <message>
        <source>Start again after the last stroke</source>
        <translation>終わったら最初から再生します</translation>
    </message>
    <message>
        <source>G&amp;roove only</source>
        <translation>溝だけ(&amp;R)</translation>
    </message>
    <message>
        <source>Follow the groove without lines</source>
        <translation>線を表示せず、溝だけを頼りに書きます</translation>
    </message>
    <message>
        <source>&amp;Starting points only</source>
        <translation>書き始めだけ(&amp;S)</translation>
    </message>
    <message>
        <source>Numbers show where each stroke starts</source>
        <translation>番号が書き始めを示します</translation>
    </message>
    <message>
        <source>&amp;Undo stroke</source>
        <translation>一画取り消す(&amp;U)</translation>
    </message>
    <message>
        <source>Undo the last stroke</source>
        <translation>最後の画を取り消します</translation>
    </message>
    <message>
        <source>&amp;Finish</source>
        <translation>判定(&amp;F)</translation>
    </message>
    <message>
        <source>Check what you wrote</source>
        <translation>書いた字を判定します</translation>
    </message>
    <message>
        <source>&amp;Hint</source>
        <translation>ヒント(&amp;H)</translation>
    </message>
    <message>
        <source>Show the next stroke; press again to show all of them</source>
        <translation>次の画を表示します。もう一度押すと残りをすべて表示します</translation>
    </message>
    <message>
        <source>Show a&amp;nswer</source>
        <translation>答えを見る(&amp;N)</translation>
    </message>
    <message>
        <source>Show how the character is written</source>
        <translation>書き方を表示します</translation>
    </message>
    <message>
        <source>Chec&amp;k each stroke</source>
        <translation>一画ごとに判定(&amp;K)</translation>
    </message>
    <message>
        <source>Check each stroke as you finish it, or everything at the end</source>
        <translation>一画ごとに判定するか、最後にまとめて判定するかを切り替えます</translation>
    </message>
    <message>
        <source>Tablet: &amp;blank</source>
        <translation>文字板：溝なし(&amp;B)</translation>
    </message>
    <message>
        <source>Hide the grooves</source>
        <translation>溝を表示しません</translation>
    </message>
    <message>
        <source>Tablet: with groo&amp;ves</source>
        <translation>文字板：溝あり(&amp;V)</translation>
    </message>
    <message>
        <source>Show the grooves</source>
        <translation>溝を表示します</translation>
    </message>
    <message>
        <source>Tablet: groove &amp;after each correct stroke</source>
        <translation>文字板：書けた画だけ溝を表示(&amp;A)</translation>
    </message>
    <message>
        <source>The groove of a stroke appears once you write it correctly</source>
        <translation>正しく書けた画の溝を表示します</translation>
    </message>
    <message>
        <source>L&amp;enient</source>
        <translation>やさしい(&amp;E)</translation>
    </message>
    <message>
        <source>Check leniently</source>
        <translation>やさしく判定します</translation>
    </message>
    <message>
        <source>N&amp;ormal</source>
        <translation>ふつう(&amp;O)</translation>
    </message>
    <message>
        <source>Check about as strictly as a teacher would</source>
        <translation>ふつうの厳しさで判定します</translation>
    </message>
    <message>
        <source>St&amp;rict</source>
        <translation>きびしい(&amp;R)</translation>
    </message>
    <message>
        <source>Check strictly</source>
        <translation>きびしく判定します</translation>
    </message>
    <message>
        <source>Model o&amp;ver your writing</source>
        <translation>手本を重ねる(&amp;V)</translation>
    </message>
    <message>
        <source>Lay the model over your writing</source>
        <translation>書いた字に手本を重ねます</translation>
    </message>
    <message>
        <source>Your writing beside the &amp;model</source>
        <translation>手本と並べる(&amp;M)</translation>
    </message>
    <message>
        <source>Show your writing and the model side by side and replay both</source>
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
        <source>A force-feedback device leads your hand along the strokes; with other devices, strokes attract the stylus</source>
        <translation>力覚デバイスが手を導きます。ほかのデバイスでは画がペン先を引き寄せます</translation>
    </message>
    <message>
        <source>&amp;Writing</source>
        <translation>書く(&amp;W)</translation>
    </message>
    <message>
        <source>Di&amp;ctation</source>
        <translation>書き取り(&amp;C)</translation>
    </message>
    <message>
        <source>Write a whole word that has the character, from its reading and meaning</source>
        <translation>読みと意味から、この文字を使う言葉を全部書きます</translation>
    </message>
    <message>
        <source>Find by p&amp;arts</source>
        <translation>パーツで探す(&amp;A)</translation>
    </message>
    <message>
        <source>Find a character by the parts it is made of</source>
        <translation>文字を組み立てているパーツから探します</translation>
    </message>
    <message>
        <source>Find by &amp;radical</source>
        <translation>部首で探す(&amp;R)</translation>
    </message>
    <message>
        <source>Find a character by its radical</source>
        <translation>部首から文字を探します</translation>
    </message>
    <message>
        <source>&amp;Tell apart</source>
        <translation>見分ける(&amp;T)</translation>
    </message>
    <message>
        <source>A short drill with the characters it is confused with</source>
        <translation>間違えやすい文字を見分ける短い練習です</translation>
    </message>
    <message>
        <source>S&amp;peech</source>
        <translation>音声(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Speak</source>
        <translation>読み上げる(&amp;S)</translation>
    </message>
    <message>
        <source>Speak the reading or the word</source>
        <translation>読みまたは言葉を読み上げます</translation>
    </message>
    <message>
        <source>Speak &amp;readings</source>
        <translation>自動で読み上げる(&amp;R)</translation>
    </message>
    <message>
        <source>Speak kana and words when they are asked for, and readings after the answer</source>
        <translation>かなや言葉は出題のときに、読みは答えのあとに読み上げます</translation>
    </message>
    <message>
        <source>&amp;Best voice</source>
        <translation>最適な声(&amp;B)</translation>
    </message>
    <message>
        <source>Use the best voice that is installed</source>
        <translation>インストールされている中で最もよい声を使います</translation>
    </message>
    <message>
        <source>&amp;Open JTalk</source>
        <translation>Open JTalk(&amp;O)</translation>
    </message>
    <message>
        <source>Speak with Open JTalk</source>
        <translation>Open JTalk で読み上げます</translation>
    </message>
    <message>
        <source>Speech &amp;Dispatcher</source>
        <translation>Speech Dispatcher(&amp;D)</translation>
    </message>
    <message>
        <source>Speak with the voice of the desktop, as a screen reader does</source>
        <translation>スクリーンリーダーと同じデスクトップの声で読み上げます</translation>
    </message>
    <message>
        <source>&amp;eSpeak NG</source>
        <translation>eSpeak NG(&amp;E)</translation>
    </message>
    <message>
        <source>Speak with eSpeak NG, plainly</source>
        <translation>eSpeak NG で抑揚なしに読み上げます</translation>
    </message>
    <message>
        <source>&amp;Voice file…</source>
        <translation>声のファイル(&amp;V)…</translation>
    </message>
    <message>
        <source>Choose a voice for Open JTalk (.htsvoice)</source>
        <translation>Open JTalk の声（.htsvoice）を選びます</translation>
    </message>
    <message>
        <source>Sho&amp;w</source>
        <translation>正しい書き方(&amp;W)</translation>
    </message>
    <message>
        <source>Draw the right strokes over your writing</source>
        <translation>書いた字の上に正しい画を書きます</translation>
    </message>
    <message>
        <source>&amp;Writing cross</source>
        <translation>マス目(&amp;W)</translation>
    </message>
    <message>
        <source>Thin lines on the tablet: 十, 田 or none</source>
        <translation>文字板の細い線：十、田、なし</translation>
    </message>
    <message>
        <source>&amp;Make a model to touch…</source>
        <translation>触れる模型を作る(&amp;M)…</translation>
    </message>
    <message>
        <source>A solid with raised lines or grooves, for a 3D printer</source>
        <translation>3Dプリンター用に、浮き出した線か溝の立体を作ります</translation>
    </message>
</context>
<context>
    <name>nazori::ui::CharacterCanvas</name>
    <message>
        <source>Tablet in the making</source>
        <translation>作っている文字板</translation>
    </message>
</context>
<context>
    <name>nazori::ui::CharacterTile</name>
    <message>
        <source>%1, %2</source>
        <comment>character, meaning</comment>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>Show %1 and its words</source>
        <translation>「%1」とその言葉を表示します</translation>
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
        <source>Show or hide the list</source>
        <translation>一覧を表示／非表示にします</translation>
    </message>
    <message>
        <source>&amp;Information</source>
        <translation>文字の情報(&amp;I)</translation>
    </message>
    <message>
        <source>Show or hide the information</source>
        <translation>文字の情報を表示／非表示にします</translation>
    </message>
    <message>
        <source>The character as grooves to trace. The left button presses the stylus down; the right button turns the tablet. M: move the pen by keys</source>
        <translation>溝になった文字をなぞります。左ボタンでペン先を下ろし、右ボタンで文字板を回します。M：キーでペンを動かします</translation>
    </message>
    <message>
        <source>There are no strokes for %1 in the database. The tablet was not changed.</source>
        <translation>「%1」の画はデータベースにありません。文字板は元のままです。</translation>
    </message>
    <message>
        <source>Opened %1.</source>
        <translation>%1 を開きました。</translation>
    </message>
    <message>
        <source>Opened %1. Open a .str file to add its strokes.</source>
        <translation>%1 を開きました。.str ファイルを開くと画が加わります。</translation>
    </message>
    <message>
        <source>Write from memory</source>
        <translation>見ないで書く</translation>
    </message>
    <message>
        <source>Postponed %1 to tomorrow.</source>
        <translation>「%1」を明日に延期しました。</translation>
    </message>
    <message>
        <source>Resumed %1.</source>
        <translation>「%1」を再開しました。</translation>
    </message>
    <message>
        <source>Suspended %1 until you resume it.</source>
        <translation>「%1」を再開するまで休止します。</translation>
    </message>
    <message>
        <source>Started %1 over as a new character. Ctrl+Shift+Z: undo.</source>
        <translation>「%1」を新しい字に戻しました。Ctrl+Shift+Z で取り消せます。</translation>
    </message>
    <message>
        <source>Closed. The tablet was not changed.</source>
        <translation>閉じました。文字板はそのままです。</translation>
    </message>
    <message>
        <source>%1 is marked as known. It comes in a review %2. Ctrl+Shift+Z: undo.</source>
        <translation>%1を学習済みにしました。%2に復習します。Ctrl+Shift+Z：取り消し。</translation>
    </message>
    <message>
        <source>Writing cross off.</source>
        <translation>マス目を消しました。</translation>
    </message>
    <message>
        <source>Writing cross: 十.</source>
        <translation>マス目：十。</translation>
    </message>
    <message>
        <source>Writing cross: 田.</source>
        <translation>マス目：田。</translation>
    </message>
    <message>
        <source>Answer shown</source>
        <translation>答えを表示</translation>
    </message>
    <message>
        <source>Finish this character first: a model would show it.</source>
        <translation>先にこの文字を書き終えてください。模型を作ると答えが見えます。</translation>
    </message>
    <message>
        <source>There is no tablet to make a model of yet.</source>
        <translation>模型にする文字板がまだありません。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::CharactersCard</name>
    <message>
        <source>The list cannot be read: %1</source>
        <translation>リストを読めません：%1</translation>
    </message>
    <message>
        <source>Characters to show</source>
        <translation>表示する文字</translation>
    </message>
    <message>
        <source>Characters by strength</source>
        <translation>文字ごとの定着度</translation>
    </message>
    <message>
        <source>Characters you have studied appear here, with how well you know each one.</source>
        <translation>学習した文字がここに並び、どれほど身についたかがわかります。</translation>
    </message>
    <message>
        <source>Character</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>定着度</translation>
    </message>
    <message>
        <source>Chance of recall now</source>
        <translation>今思い出せる確率</translation>
    </message>
    <message>
        <source>%1. Enter: open a character.</source>
        <translation>%1。Enter で文字を開きます。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::ChartCard</name>
    <message>
        <source>Numbers</source>
        <translation>数値</translation>
    </message>
    <message>
        <source>Show the numbers as a table (N)</source>
        <translation>数値の表を表示します（N）</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>コピー</translation>
    </message>
    <message>
        <source>Copy the numbers (Ctrl+C)</source>
        <translation>数値をコピーします（Ctrl+C）</translation>
    </message>
    <message>
        <source>%1 Left and Right: read row by row. N: show all numbers.</source>
        <translation>%1 左右の矢印キーで1行ずつ読み、N ですべての数値を表示します。</translation>
    </message>
    <message>
        <source>Numbers of %1</source>
        <translation>%1の数値</translation>
    </message>
    <message>
        <source>Copy the numbers of %1</source>
        <translation>%1の数値をコピー</translation>
    </message>
    <message>
        <source>Left and Right: read row by row.</source>
        <translation>左右の矢印キーで1行ずつ読みます。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::CheckActions</name>
    <message>
        <source>&amp;Finish</source>
        <translation>判定(&amp;F)</translation>
    </message>
    <message>
        <source>Check what you wrote and go on</source>
        <translation>書いた字を判定して次へ進みます</translation>
    </message>
    <message>
        <source>I &amp;don&apos;t know</source>
        <translation>わからない(&amp;D)</translation>
    </message>
    <message>
        <source>Go on to the next character</source>
        <translation>次の文字へ進みます</translation>
    </message>
    <message>
        <source>&amp;Undo stroke</source>
        <translation>1画取り消す(&amp;U)</translation>
    </message>
    <message>
        <source>Undo the last stroke</source>
        <translation>最後の画を取り消します</translation>
    </message>
    <message>
        <source>&amp;Clear</source>
        <translation>消す(&amp;C)</translation>
    </message>
    <message>
        <source>Write the character again</source>
        <translation>この文字を最初から書き直します</translation>
    </message>
    <message>
        <source>&amp;End the test</source>
        <translation>テストをやめる(&amp;E)</translation>
    </message>
    <message>
        <source>Go back to the questions; nothing is saved</source>
        <translation>質問に戻ります。何も保存されません</translation>
    </message>
    <message>
        <source>T&amp;est</source>
        <translation>テスト(&amp;E)</translation>
    </message>
</context>
<context>
    <name>nazori::ui::CheckPage</name>
    <message>
        <source>&amp;Test</source>
        <translation>テスト(&amp;T)</translation>
    </message>
    <message>
        <source>What you can write already, in two minutes</source>
        <translation>今書ける文字を2分で調べます</translation>
    </message>
    <message>
        <source>An empty tablet to write on from memory</source>
        <translation>見ないで書くための空の文字板</translation>
    </message>
    <message>
        <source>Write the character first, or press I if you don&apos;t know it.</source>
        <translation>先に文字を書いてください。わからないときは I を押します。</translation>
    </message>
    <message>
        <source>The writing could not be checked: %1.</source>
        <translation>書いた字を判定できませんでした：%1。</translation>
    </message>
    <message>
        <source>Questions answered</source>
        <translation>答えた質問</translation>
    </message>
    <message>
        <source>Finish  ⏎</source>
        <translation>判定  ⏎</translation>
    </message>
    <message>
        <source>I don&apos;t know  (I)</source>
        <translation>わからない (I)</translation>
    </message>
    <message>
        <source>End the test</source>
        <translation>テストをやめる</translation>
    </message>
    <message>
        <source>Question %1 of about %2. Write from memory.</source>
        <translation>約%2問中の%1問目。見ないで書いてください。</translation>
    </message>
    <message>
        <source>Write: %1</source>
        <translation>書いてください：%1</translation>
    </message>
    <message>
        <source>The test was ended. Nothing was saved.</source>
        <translation>テストをやめました。何も保存されていません。</translation>
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
        <translation>デバイスを探す(&amp;L)</translation>
    </message>
    <message>
        <source>Search again for connected devices</source>
        <translation>接続されたデバイスをもう一度探します</translation>
    </message>
    <message>
        <source>S&amp;tronger</source>
        <translation>強く(&amp;T)</translation>
    </message>
    <message>
        <source>Make the test force stronger by 10% of the device&apos;s limit</source>
        <translation>試す力をデバイスの上限の10%だけ強くします</translation>
    </message>
    <message>
        <source>&amp;Weaker</source>
        <translation>弱く(&amp;W)</translation>
    </message>
    <message>
        <source>Make the test force weaker</source>
        <translation>試す力を弱くします</translation>
    </message>
    <message>
        <source>Calibrate with &amp;corners…</source>
        <translation>隅を指して位置合わせ(&amp;C)…</translation>
    </message>
    <message>
        <source>Point at three corners of the tablet with the stylus</source>
        <translation>文字板の3つの隅をペン先で指します</translation>
    </message>
    <message>
        <source>&amp;Fit automatically</source>
        <translation>自動で合わせる(&amp;F)</translation>
    </message>
    <message>
        <source>Use the largest tablet that the stylus can reach completely</source>
        <translation>ペン先が隅まで届くいちばん大きな文字板にします</translation>
    </message>
    <message>
        <source>&amp;Device</source>
        <translation>デバイス(&amp;D)</translation>
    </message>
    <message>
        <source>Choose a &amp;device</source>
        <translation>デバイスを選ぶ(&amp;D)</translation>
    </message>
    <message>
        <source>Go to the list of devices</source>
        <translation>デバイスの一覧に移ります</translation>
    </message>
    <message>
        <source>Lar&amp;ger ball at the tip</source>
        <translation>ペン先の球を大きく(&amp;G)</translation>
    </message>
    <message>
        <source>Make the ball at the tip of the stylus half a millimetre larger</source>
        <translation>ペン先の球の半径を 0.5 mm 大きくします</translation>
    </message>
    <message>
        <source>S&amp;maller ball at the tip</source>
        <translation>ペン先の球を小さく(&amp;M)</translation>
    </message>
    <message>
        <source>Make the ball at the tip of the stylus half a millimetre smaller; 0 is a point</source>
        <translation>ペン先の球の半径を 0.5 mm 小さくします。0 にすると点になります</translation>
    </message>
</context>
<context>
    <name>nazori::ui::DeviceChoicePanel</name>
    <message>
        <source>Searching for devices…</source>
        <translation>デバイスを探しています…</translation>
    </message>
    <message>
        <source>Set corner here</source>
        <translation>この位置に決める</translation>
    </message>
    <message>
        <source>Devices and their position</source>
        <translation>デバイスと位置</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>デバイス</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>位置合わせ</translation>
    </message>
    <message>
        <source>Writing hand</source>
        <translation>書く手</translation>
    </message>
    <message>
        <source>Right hand</source>
        <translation>右手</translation>
    </message>
    <message>
        <source>Left hand</source>
        <translation>左手</translation>
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
        <source>Angle of your seat to the device</source>
        <translation>デバイスに対する座る向き</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>Stylus buttons</source>
        <translation>ペンのボタン</translation>
    </message>
    <message>
        <source>do nothing</source>
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
        <translation>すべての画</translation>
    </message>
    <message>
        <source>clear ink</source>
        <translation>書いた線を消す</translation>
    </message>
    <message>
        <source>First button</source>
        <translation>1つ目のボタン</translation>
    </message>
    <message>
        <source>Second button</source>
        <translation>2つ目のボタン</translation>
    </message>
    <message>
        <source>Limits</source>
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
        <source>Automatic (best available)</source>
        <translation>自動（最適なデバイス）</translation>
    </message>
    <message>
        <source>%1 – in use</source>
        <translation>%1 – 使用中</translation>
    </message>
    <message>
        <source>%1 – not connected</source>
        <translation>%1 – 未接続</translation>
    </message>
    <message>
        <source>Calibrated with corners: 1 cm of hand movement is %1 cm on the tablet.</source>
        <translation>隅で位置合わせをしました。手の 1 cm が文字板の %1 cm です。</translation>
    </message>
    <message>
        <source>Automatic fit: 1 cm of hand movement is %1 cm on the tablet.</source>
        <translation>自動で合わせました。手の 1 cm が文字板の %1 cm です。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::DevicePage</name>
    <message>
        <source>&amp;Device</source>
        <translation>デバイス(&amp;D)</translation>
    </message>
    <message>
        <source>The device you feel the tablet with, and the material of the tablet</source>
        <translation>文字板に触れるデバイスと、文字板の材質</translation>
    </message>
    <message>
        <source>&amp;Devices</source>
        <translation>デバイスの一覧(&amp;D)</translation>
    </message>
    <message>
        <source>Show or hide the devices</source>
        <translation>デバイスの一覧を表示／非表示にします</translation>
    </message>
    <message>
        <source>&amp;What you feel</source>
        <translation>手ごたえ(&amp;W)</translation>
    </message>
    <message>
        <source>Show or hide what you feel</source>
        <translation>手ごたえを表示／非表示にします</translation>
    </message>
    <message>
        <source>A tablet to try the stylus on: a wall on the left, a groove on the right</source>
        <translation>ペン先を試す文字板。左に壁、右に溝があります</translation>
    </message>
    <message>
        <source>Touch the wall and the groove gently. The force grows only when you ask for it.</source>
        <translation>壁と溝にそっと触れてみてください。力は「強く」を押したときだけ強くなります。</translation>
    </message>
    <message>
        <source>With a mouse or pen you can only see the wall and the groove. Plug in a force-feedback device to feel them.</source>
        <translation>マウスとペンでは壁と溝が見えるだけです。力覚デバイスをつなぐと、手ごたえが伝わります。</translation>
    </message>
    <message>
        <source>The tablet is now as large as the stylus can reach.</source>
        <translation>文字板をペン先の届く範囲いっぱいに合わせました。</translation>
    </message>
    <message>
        <source>%1 is working again. Your writing is still there.</source>
        <translation>%1 がまた使えます。書いたものはそのまま残っています。</translation>
    </message>
    <message>
        <source>Now using %1.</source>
        <translation>%1 を使っています。</translation>
    </message>
    <message>
        <source>%1 Until then, %2 is used.</source>
        <translation>%1それまでは %2 を使います。</translation>
    </message>
    <message>
        <source>The position of the tablet was updated.</source>
        <translation>文字板を設定どおりの向きにしました。</translation>
    </message>
    <message>
        <source>%1 Until then, use a mouse or pen.</source>
        <translation>%1それまではマウスとペンで書けます。</translation>
    </message>
    <message>
        <source>There is no device to calibrate.</source>
        <translation>位置合わせするデバイスがありません。</translation>
    </message>
    <message>
        <source>1 of 3: hold the tip where you want the bottom left corner.</source>
        <translation>1／3：左下の隅にしたい所にペン先を置いてください。</translation>
    </message>
    <message>
        <source>Point at three corners for the tablet, in the air or on your desk.</source>
        <translation>空中か机の上で、文字板の3つの隅を指してください。</translation>
    </message>
    <message>
        <source>The device was disconnected. The tablet was not changed.</source>
        <translation>デバイスの接続が切れました。文字板は元のままです。</translation>
    </message>
    <message>
        <source>2 of 3: hold the tip where you want the bottom right corner.</source>
        <translation>2／3：右下の隅にしたい所にペン先を置いてください。</translation>
    </message>
    <message>
        <source>3 of 3: hold the tip where you want the top left corner.</source>
        <translation>3／3：左上の隅にしたい所にペン先を置いてください。</translation>
    </message>
    <message>
        <source>These corners do not form a tablet. Point at them in order, at least 2 cm apart, as the corners of a square. The tablet was not changed.</source>
        <translation>この3つの隅では文字板になりません。正方形になるように、2 cm 以上離して順番に指してください。文字板は元のままです。</translation>
    </message>
    <message>
        <source>The tablet is now where you pointed.</source>
        <translation>指した位置に文字板を置きました。</translation>
    </message>
    <message>
        <source>Radius of the ball at the tip: %1 mm.</source>
        <translation>ペン先の球の半径：%1 mm。</translation>
    </message>
    <message>
        <source>The tip is a point.</source>
        <translation>ペン先は点です。</translation>
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
        <source>Simulated devices</source>
        <translation>模擬デバイス</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>%1: the manufacturer&apos;s library is not installed.</source>
        <translation>%1：製造元のライブラリがインストールされていません。</translation>
    </message>
    <message>
        <source>%1: the manufacturer&apos;s library is too old or the wrong one. Install a newer version.</source>
        <translation>%1：製造元のライブラリが古いか、別のものです。新しいものをインストールしてください。</translation>
    </message>
    <message>
        <source>%1: the manufacturer&apos;s service is not responding. Start it.</source>
        <translation>%1：製造元のサービスが応答しません。起動してください。</translation>
    </message>
    <message>
        <source>%1: no device is connected. Check the cable and the power.</source>
        <translation>%1：何もつながっていません。ケーブルと電源を確かめてください。</translation>
    </message>
    <message>
        <source>%1 is connected, but you do not have permission to use it. Add yourself to its group or install its udev rule.</source>
        <translation>%1 は接続されていますが、使う権限がありません。デバイスのグループに加わるか、udev ルールを入れてください。</translation>
    </message>
    <message>
        <source>%1 is in use. Close the program that uses it.</source>
        <translation>%1 は使用中です。使っているプログラムを閉じてください。</translation>
    </message>
    <message>
        <source>%1 is connected but does not start. Unplug it and plug it in again.</source>
        <translation>%1 は接続されていますが、起動しません。抜いてもう一度つないでください。</translation>
    </message>
    <message>
        <source>%1: the saved calibration cannot be used. Calibrate it again.</source>
        <translation>%1：保存された位置合わせが使えません。もう一度位置合わせをしてください。</translation>
    </message>
    <message>
        <source>%1 rests in its inkwell. Take the stylus out to go on.</source>
        <translation>%1 はペン立てに収まっています。ペンを取ると続きます。</translation>
    </message>
    <message>
        <source>%1 gives no force. Hold its safety switch.</source>
        <translation>%1 は力を出していません。安全スイッチを押したままにしてください。</translation>
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
        <source>%1 paused because the force was too large. It resumes by itself.</source>
        <translation>%1 は力が大きすぎたため一時停止しました。自動で再開します。</translation>
    </message>
    <message>
        <source>%1 paused because it was moved too fast. It resumes by itself.</source>
        <translation>%1 は動きが速すぎたため一時停止しました。自動で再開します。</translation>
    </message>
    <message>
        <source>The motors of %1 are too warm. It resumes when they have cooled down.</source>
        <translation>%1 のモーターが熱くなりました。冷めると再開します。</translation>
    </message>
    <message>
        <source>%1 is switched off, or its brake is on. Switch it on.</source>
        <translation>%1 の電源が切れているか、ブレーキがかかっています。電源を入れてください。</translation>
    </message>
    <message>
        <source>%1 responds too slowly for safe force feedback. Close other programs, or connect it by cable.</source>
        <translation>%1 の応答が遅く、安全に力を返せません。ほかのプログラムを閉じるか、ケーブルで接続してください。</translation>
    </message>
    <message>
        <source>The connection to %1 was lost. Check the cable.</source>
        <translation>%1 との接続が切れました。ケーブルを確かめてください。</translation>
    </message>
    <message>
        <source>%1 reports a fault. Switch it off and on again.</source>
        <translation>%1 が異常を知らせています。電源を入れ直してください。</translation>
    </message>
    <message>
        <source>The library of %1 gets no timer from the system. Close other programs.</source>
        <translation>%1 のライブラリがシステムのタイマーを使えません。ほかのプログラムを閉じてください。</translation>
    </message>
    <message>
        <source>%1 no longer responds. Unplug it and plug it in again.</source>
        <translation>%1 が応答しなくなりました。抜いてもう一度つないでください。</translation>
    </message>
    <message>
        <source>The service for %1 has stopped. Start it again.</source>
        <translation>%1 のサービスが止まりました。もう一度起動してください。</translation>
    </message>
    <message>
        <source>%1 sends data that cannot be read. Update its service.</source>
        <translation>%1 から届くデータが読み取れません。サービスを更新してください。</translation>
    </message>
    <message>
        <source>%1 (simulated)</source>
        <translation>%1（シミュレーション）</translation>
    </message>
</context>
<context>
    <name>nazori::ui::DictationView</name>
    <message>
        <source>Ne&amp;xt word</source>
        <translation>次の言葉(&amp;X)</translation>
    </message>
    <message>
        <source>Write another word that has the character</source>
        <translation>この文字を使う別の言葉を書きます</translation>
    </message>
    <message>
        <source>The word to write</source>
        <translation>書く言葉</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>Character %1 of %2. H: hint. Enter: finish.</source>
        <translation>%2文字中%1文字目です。H：ヒント、Enter：判定</translation>
    </message>
    <message>
        <source>%1: shown, not written from memory.</source>
        <translation>%1：手本を見たので、見ないで書いたことにはなりません。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Correct: %1/100</source>
        <translation>正解：100点中%1点</translation>
    </message>
    <message>
        <source>No word of two or three characters can be asked for. Choose another character.</source>
        <translation>この文字には、書き取りに使える2文字か3文字の言葉がありません。別の文字を選んでください。</translation>
    </message>
    <message>
        <source>The word is finished. Enter: next word. Delete: write it again.</source>
        <translation>この言葉は書き終わりました。Enter：次の言葉、Delete：書き直す</translation>
    </message>
    <message>
        <source>Write the word %1 (%2). %3</source>
        <translation>「%1」（%2）を書いてください。%3</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1%2</translation>
    </message>
    <message>
        <source>%1 is right: %2 of 100 points. Enter: next word.</source>
        <translation>「%1」は正解です。100点中%2点。Enter：次の言葉</translation>
    </message>
    <message>
        <source>one syllable of two kana</source>
        <translation>かな2字で1音</translation>
    </message>
    <message>
        <source>Not quite</source>
        <translation>もう少し</translation>
    </message>
    <message>
        <source>%1 is not right yet. Delete: write it again. Enter: next word.</source>
        <translation>「%1」はまだ正しくありません。Enter：次の言葉、Delete：書き直す</translation>
    </message>
</context>
<context>
    <name>nazori::ui::DrawPanel</name>
    <message>
        <source>Draw to find</source>
        <translation>手書きで探す</translation>
    </message>
    <message>
        <source>Similar characters</source>
        <translation>似ている文字</translation>
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
        <source>Your drawing could not be recognised: %1.</source>
        <translation>書いた形を読み取れませんでした：%1。</translation>
    </message>
    <message>
        <source>Draw the character you are looking for. Stroke order and direction hardly matter.</source>
        <translation>探している文字を書いてください。書き順や向きは多少違ってもかまいません。</translation>
    </message>
    <message>
        <source>Best match: %1. Enter: open it.</source>
        <translation>「%1」がいちばん似ています。Enter で開きます。</translation>
    </message>
    <message>
        <source>%1, %2 of %3.</source>
        <translation>%1（%3字中%2番目）。</translation>
    </message>
    <message>
        <source>hiragana</source>
        <translation>ひらがな</translation>
    </message>
    <message>
        <source>katakana</source>
        <translation>カタカナ</translation>
    </message>
    <message>
        <source>digit</source>
        <translation>数字</translation>
    </message>
    <message>
        <source>letter</source>
        <translation>英字</translation>
    </message>
    <message>
        <source>sign</source>
        <translation>記号</translation>
    </message>
    <message>
        <source>kanji</source>
        <translation>漢字</translation>
    </message>
    <message>
        <source>kanji, %1</source>
        <translation>漢字、%1</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>Enter: open the first match. Arrow keys: choose another. Page Down: search only kana, kanji or letters. Ctrl+Z: undo a stroke. Delete: clear. Esc: close.</source>
        <translation>Enter：最初の候補を開く。矢印キー：ほかの候補を選ぶ。Page Down：かな、漢字、英字だけから探す。Ctrl+Z：1画戻す。Delete：消す。Esc：閉じる。</translation>
    </message>
    <message>
        <source>Search among</source>
        <translation>探す範囲</translation>
    </message>
    <message>
        <source>Which characters are searched (Page Up, Page Down)</source>
        <translation>どの文字から探すか（Page Up、Page Down）</translation>
    </message>
    <message>
        <source>All characters</source>
        <translation>すべての文字</translation>
    </message>
    <message>
        <source>Kana</source>
        <translation>かな</translation>
    </message>
    <message>
        <source>Kanji</source>
        <translation>漢字</translation>
    </message>
    <message>
        <source>Letters and digits</source>
        <translation>英字・数字</translation>
    </message>
    <message>
        <source>Searching: %1.</source>
        <translation>探す範囲：%1。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::DrawingPad</name>
    <message>
        <source>Draw the character here</source>
        <translation>ここに文字を書いてください</translation>
    </message>
</context>
<context>
    <name>nazori::ui::DrillDialog</name>
    <message>
        <source>&amp;Write them</source>
        <translation>書いてみる(&amp;W)</translation>
    </message>
    <message>
        <source>Which one is it?</source>
        <translation>どちらの文字？</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Key %1</source>
        <translation>キー %1</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>閉じる(&amp;C)</translation>
    </message>
    <message>
        <source>Which character belongs here? Press 1 to %1.</source>
        <translation>当てはまる文字はどれ？ 1～%1のキーで答えてください。</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1／%2</translation>
    </message>
    <message>
        <source>%1 of %2 right</source>
        <translation>%2問中%1問正解</translation>
    </message>
    <message>
        <source>✓ Correct: %1, %2.</source>
        <translation>✓ 正解：%1（%2）。</translation>
    </message>
    <message>
        <source>✗ It is %1 (%2), not %3.</source>
        <translation>✗ 正しくは%1（%2）です。%3ではありません。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::ExchangeProgress</name>
    <message>
        <source>An export, import or backup is already running. Wait for it or stop it.</source>
        <translation>書き出し、読み込み、バックアップのどれかが進行中です。終わるまで待つか、止めてください。</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>止める</translation>
    </message>
    <message>
        <source>Stopped. Nothing was changed.</source>
        <translation>止めました。すべて元のままです。</translation>
    </message>
    <message>
        <source>%1: %2. Nothing was changed.</source>
        <translation>%1：%2。すべて元のままです。</translation>
    </message>
    <message>
        <source>Exporting %1…</source>
        <translation>%1 を書き出し中…</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>%1 に保存しました。</translation>
    </message>
    <message>
        <source>Importing %1…</source>
        <translation>%1 を読み込み中…</translation>
    </message>
    <message>
        <source>Imported %2 characters for %1. Now studying as %1.</source>
        <translation>%1 に%2字を読み込みました。現在の学習者は %1 です。</translation>
    </message>
    <message>
        <source>Nothing studied yet, so there is nothing to back up.</source>
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
        <source>Backup failed: %1.</source>
        <translation>バックアップできませんでした：%1。</translation>
    </message>
    <message>
        <source>Restoring the backup…</source>
        <translation>バックアップから復元中…</translation>
    </message>
    <message>
        <source>Backup restored. Your previous data was backed up.</source>
        <translation>復元しました。前のデータはバックアップしてあります。</translation>
    </message>
    <message>
        <source>The backup could not be restored: %1. Nothing was changed.</source>
        <translation>復元できませんでした：%1。すべて元のままです。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::FeedbackLine</name>
    <message>
        <source>Feedback</source>
        <translation>お知らせ</translation>
    </message>
</context>
<context>
    <name>nazori::ui::FeelPanel</name>
    <message>
        <source>at rest</source>
        <translation>待機中</translation>
    </message>
    <message>
        <source>What you feel</source>
        <translation>ペン先の手ごたえ</translation>
    </message>
    <message>
        <source>Now</source>
        <translation>今</translation>
    </message>
    <message>
        <source>Tip position</source>
        <translation>ペン先の位置</translation>
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
        <source>Update rate</source>
        <translation>更新頻度</translation>
    </message>
    <message>
        <source>Longest delay</source>
        <translation>最大の遅れ</translation>
    </message>
    <message>
        <source>Missed updates</source>
        <translation>抜けた更新</translation>
    </message>
    <message>
        <source>Latency</source>
        <translation>遅延</translation>
    </message>
    <message>
        <source>Feel a wall and a groove</source>
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
        <translation>粘性</translation>
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
        <source>Pop-through</source>
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
        <source>Tip of the stylus</source>
        <translation>ペン先</translation>
    </message>
    <message>
        <source>Radius of the ball</source>
        <translation>球の半径</translation>
    </message>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>0 is a point. A ball does not reach the bottom of a groove that is narrower than it.</source>
        <translation>0 にすると点になります。球より細い溝の底には届きません。</translation>
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
        <source>%1 times per second</source>
        <translation>毎秒%1回</translation>
    </message>
    <message>
        <source>%1 ms</source>
        <translation>%1 ms</translation>
    </message>
    <message>
        <source>Force at %1% of the device&apos;s limits. A wall is on the left, a groove on the right.</source>
        <translation>力はデバイスの上限の%1%です。左に壁、右に溝があります。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::FileExchange</name>
    <message>
        <source>The character</source>
        <translation>この文字</translation>
    </message>
    <message>
        <source>%1: %2. The tablet was not changed.</source>
        <translation>%1：%2。文字板は元のままです。</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>%1 に保存しました。</translation>
    </message>
    <message>
        <source>Open a height map, a stroke order file, or both</source>
        <translation>高さマップ、書き順、またはその両方を開く</translation>
    </message>
    <message>
        <source>Height maps and stroke order files (*.raw *.png *.str);;All files (*)</source>
        <translation>高さマップと書き順 (*.raw *.png *.str);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>%1 is one file too many: open one height map and one stroke order file. The tablet was not changed.</source>
        <translation>%1 は余分です。高さマップと書き順は1つずつ開いてください。文字板は元のままです。</translation>
    </message>
    <message>
        <source>%1 is not a RAW, PNG or .str file. The tablet was not changed.</source>
        <translation>%1 は RAW、PNG、.str のどれでもありません。文字板は元のままです。</translation>
    </message>
    <message>
        <source>Grid size</source>
        <translation>グリッドの大きさ</translation>
    </message>
    <message>
        <source>%1 does not contain its grid size.
Columns and rows:</source>
        <translation>%1 にはグリッドの大きさが書かれていません。
1辺の点の数：</translation>
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
        <source>Go to the expression box</source>
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
        <source>Show half the range, centred on the point</source>
        <translation>点を中心に範囲を半分にします</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>縮小(&amp;O)</translation>
    </message>
    <message>
        <source>Show twice the range, centred on the point</source>
        <translation>点を中心に範囲を2倍にします</translation>
    </message>
    <message>
        <source>Reset vie&amp;w</source>
        <translation>最初の範囲に戻す(&amp;W)</translation>
    </message>
    <message>
        <source>Go back to the original range</source>
        <translation>最初の範囲に戻します</translation>
    </message>
    <message>
        <source>Save the height map as &amp;RAW…</source>
        <translation>高さマップを RAW で保存(&amp;R)…</translation>
    </message>
    <message>
        <source>8-bit height map without a header, as in the 2005 program</source>
        <translation>2005年版と同じ、ヘッダーのない8ビットの高さマップ</translation>
    </message>
    <message>
        <source>Save the height map as P&amp;NG…</source>
        <translation>高さマップを PNG で保存(&amp;N)…</translation>
    </message>
    <message>
        <source>16-bit greyscale height map</source>
        <translation>16ビット・グレースケールの高さマップ</translation>
    </message>
    <message>
        <source>Save for &amp;tactile paper…</source>
        <translation>立体コピー用に保存(&amp;T)…</translation>
    </message>
    <message>
        <source>Black and white picture with thick lines, for swell paper and for low vision</source>
        <translation>太い線の白黒画像。立体コピー用紙や弱視の方に向いています</translation>
    </message>
    <message>
        <source>Save the s&amp;ound…</source>
        <translation>音を保存(&amp;O)…</translation>
    </message>
    <message>
        <source>Save the sound of all curves as WAV</source>
        <translation>すべての曲線の音を WAV で保存します</translation>
    </message>
    <message>
        <source>Forward &amp;along the curve</source>
        <translation>曲線に沿って進む(&amp;A)</translation>
    </message>
    <message>
        <source>Move right by 1% of the range</source>
        <translation>範囲の1%だけ右へ進みます</translation>
    </message>
    <message>
        <source>&amp;Back along the curve</source>
        <translation>曲線に沿って戻る(&amp;B)</translation>
    </message>
    <message>
        <source>Move left by 1% of the range</source>
        <translation>範囲の1%だけ左へ戻ります</translation>
    </message>
    <message>
        <source>To the next &amp;tick</source>
        <translation>次の目盛りへ(&amp;T)</translation>
    </message>
    <message>
        <source>Go along the curve to the next tick of the x axis</source>
        <translation>曲線に沿って x 軸の次の目盛りまで進みます</translation>
    </message>
    <message>
        <source>To the previous tic&amp;k</source>
        <translation>前の目盛りへ(&amp;K)</translation>
    </message>
    <message>
        <source>Go back along the curve to the previous tick</source>
        <translation>曲線に沿って前の目盛りまで戻ります</translation>
    </message>
    <message>
        <source>To the &amp;start</source>
        <translation>始まりへ(&amp;S)</translation>
    </message>
    <message>
        <source>Go to the start of this branch of the curve</source>
        <translation>曲線のこのパーツの始まりへ移ります</translation>
    </message>
    <message>
        <source>To the &amp;end</source>
        <translation>終わりへ(&amp;E)</translation>
    </message>
    <message>
        <source>Go to the end of this branch of the curve</source>
        <translation>曲線のこのパーツの終わりへ移ります</translation>
    </message>
    <message>
        <source>&amp;Next curve or branch</source>
        <translation>次の曲線・枝(&amp;N)</translation>
    </message>
    <message>
        <source>Go to the next curve or branch</source>
        <translation>次の曲線または枝へ移ります</translation>
    </message>
    <message>
        <source>&amp;Previous curve or branch</source>
        <translation>前の曲線・枝(&amp;P)</translation>
    </message>
    <message>
        <source>Go to the previous curve or branch</source>
        <translation>前の曲線または枝へ移ります</translation>
    </message>
    <message>
        <source>Next po&amp;int</source>
        <translation>次の注目点(&amp;I)</translation>
    </message>
    <message>
        <source>Go to the next point of interest</source>
        <translation>次の注目点へ移ります</translation>
    </message>
    <message>
        <source>Previous p&amp;oint</source>
        <translation>前の注目点(&amp;O)</translation>
    </message>
    <message>
        <source>Go to the previous point of interest</source>
        <translation>前の注目点へ移ります</translation>
    </message>
    <message>
        <source>Pan &amp;left</source>
        <translation>範囲を左へ(&amp;L)</translation>
    </message>
    <message>
        <source>Show more on the left</source>
        <translation>左側を表示します</translation>
    </message>
    <message>
        <source>Pan r&amp;ight</source>
        <translation>範囲を右へ(&amp;I)</translation>
    </message>
    <message>
        <source>Show more on the right</source>
        <translation>右側を表示します</translation>
    </message>
    <message>
        <source>Pan &amp;up</source>
        <translation>範囲を上へ(&amp;U)</translation>
    </message>
    <message>
        <source>Show more above</source>
        <translation>上側を表示します</translation>
    </message>
    <message>
        <source>Pan &amp;down</source>
        <translation>範囲を下へ(&amp;D)</translation>
    </message>
    <message>
        <source>Show more below</source>
        <translation>下側を表示します</translation>
    </message>
    <message>
        <source>&amp;Coordinates</source>
        <translation>座標(&amp;C)</translation>
    </message>
    <message>
        <source>Read out the coordinates of the point</source>
        <translation>点の座標を読み上げます</translation>
    </message>
    <message>
        <source>S&amp;lope</source>
        <translation>傾き(&amp;L)</translation>
    </message>
    <message>
        <source>Read out the slope of the curve here</source>
        <translation>ここでの曲線の傾きを読み上げます</translation>
    </message>
    <message>
        <source>Su&amp;mmary</source>
        <translation>要約(&amp;M)</translation>
    </message>
    <message>
        <source>Describe the plot in one sentence</source>
        <translation>グラフを1文で説明します</translation>
    </message>
    <message>
        <source>A&amp;dd a marker</source>
        <translation>目印を置く(&amp;D)</translation>
    </message>
    <message>
        <source>Mark this place</source>
        <translation>この場所に目印を置きます</translation>
    </message>
    <message>
        <source>&amp;Go to the next marker</source>
        <translation>次の目印へ(&amp;G)</translation>
    </message>
    <message>
        <source>Go to the next marked place</source>
        <translation>次の目印へ移ります</translation>
    </message>
    <message>
        <source>Next branch only</source>
        <translation>次の曲線だけ</translation>
    </message>
    <message>
        <source>Only the next branch attracts the stylus</source>
        <translation>次の曲線だけがペン先を引き寄せます</translation>
    </message>
    <message>
        <source>Previous branch only</source>
        <translation>前の曲線だけ</translation>
    </message>
    <message>
        <source>Only the previous branch attracts the stylus</source>
        <translation>前の曲線だけがペン先を引き寄せます</translation>
    </message>
    <message>
        <source>All branches</source>
        <translation>すべての曲線</translation>
    </message>
    <message>
        <source>All branches attract the stylus</source>
        <translation>どの曲線もペン先を引き寄せます</translation>
    </message>
    <message>
        <source>Snap</source>
        <translation>引き寄せ</translation>
    </message>
    <message>
        <source>Curves attract the stylus</source>
        <translation>曲線がペン先を引き寄せます</translation>
    </message>
    <message>
        <source>Clear ink</source>
        <translation>書いた線を消す</translation>
    </message>
    <message>
        <source>Clear the tablet</source>
        <translation>グラフに書いた線を消します</translation>
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
        <source>Stop all sounds and the drawing</source>
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
        <source>Play the curves more slowly</source>
        <translation>曲線を遅く鳴らします</translation>
    </message>
    <message>
        <source>L&amp;ouder</source>
        <translation>音を大きく(&amp;O)</translation>
    </message>
    <message>
        <source>Turn the volume up</source>
        <translation>音量を上げます</translation>
    </message>
    <message>
        <source>&amp;Quieter</source>
        <translation>音を小さく(&amp;Q)</translation>
    </message>
    <message>
        <source>Turn the volume down</source>
        <translation>音量を下げます</translation>
    </message>
    <message>
        <source>&amp;Mute</source>
        <translation>消音(&amp;M)</translation>
    </message>
    <message>
        <source>Turn off all sound</source>
        <translation>すべての音を消します</translation>
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
        <source>Carve and play only one curve</source>
        <translation>1本の曲線だけを彫り、鳴らします</translation>
    </message>
    <message>
        <source>Only the next cur&amp;ve</source>
        <translation>次の曲線だけ(&amp;V)</translation>
    </message>
    <message>
        <source>Carve and play only the next curve; after the last one, all of them</source>
        <translation>次の曲線だけを彫り、鳴らします。最後の曲線の次はすべてに戻ります</translation>
    </message>
    <message>
        <source>&amp;Tone of y = 0</source>
        <translation>y = 0 の音(&amp;T)</translation>
    </message>
    <message>
        <source>Play the tone of y = 0 for comparison</source>
        <translation>比べるための y = 0 の音を鳴らします</translation>
    </message>
    <message>
        <source>Spoken &amp;form</source>
        <translation>読み上げ方(&amp;F)</translation>
    </message>
    <message>
        <source>Change how expressions are read: verbose, brief, superbrief</source>
        <translation>式の読み上げ方を変えます：くわしく、短く、ごく短く</translation>
    </message>
    <message>
        <source>&amp;Make a model to touch…</source>
        <translation>触れる模型を作る(&amp;M)…</translation>
    </message>
    <message>
        <source>A solid with raised curves, axes and numbers in braille, for a 3D printer</source>
        <translation>3Dプリンター用に、浮き出した曲線と軸、点字の数字の立体を作ります</translation>
    </message>
</context>
<context>
    <name>nazori::ui::FunctionsPage</name>
    <message>
        <source>F&amp;unctions</source>
        <translation>関数(&amp;U)</translation>
    </message>
    <message>
        <source>Curves to see, feel and hear</source>
        <translation>見て、触れて、聴く曲線</translation>
    </message>
    <message>
        <source>&amp;Expression and range</source>
        <translation>式と範囲(&amp;E)</translation>
    </message>
    <message>
        <source>Show or hide the expression</source>
        <translation>式の欄を表示／非表示にします</translation>
    </message>
    <message>
        <source>&amp;Points of interest</source>
        <translation>注目点(&amp;P)</translation>
    </message>
    <message>
        <source>Show or hide the points of interest</source>
        <translation>注目点を表示／非表示にします</translation>
    </message>
    <message>
        <source>The plot as grooves. Left and Right: move along the curve. Up and Down: go to another curve. N: next point of interest. H: play it. S: summary. Ctrl+L: expression. Ctrl+T: table</source>
        <translation>溝として彫られたグラフ。左右の矢印キーで曲線に沿って動き、上下の矢印キーで別の曲線へ移ります。N：次の注目点、H：音を鳴らす、S：要約、Ctrl+L：式、Ctrl+T：表</translation>
    </message>
    <message>
        <source>This range cannot be shown: %1.</source>
        <translation>この範囲は表示できません：%1。</translation>
    </message>
    <message>
        <source>“%1” is not a number. The range was not changed.</source>
        <translation>「%1」は数ではありません。範囲は変わっていません。</translation>
    </message>
    <message>
        <source>Snapping on: curves attract the stylus.</source>
        <translation>引き寄せを入れました。曲線がペン先を引き寄せます。</translation>
    </message>
    <message>
        <source>Snapping off: the stylus moves freely.</source>
        <translation>引き寄せを切りました。ペン先は自由に動きます。</translation>
    </message>
    <message>
        <source>The drawing was stopped and may be incomplete.</source>
        <translation>描画を止めました。まだ途中かもしれません。</translation>
    </message>
    <message>
        <source>The curve is still being drawn.</source>
        <translation>曲線を描いているところです。</translation>
    </message>
    <message>
        <source>Sound is not available on this computer.</source>
        <translation>このコンピューターでは音を出せません。</translation>
    </message>
    <message>
        <source>Volume %1</source>
        <translation>音量 %1</translation>
    </message>
    <message>
        <source>This cannot be drawn: %1. The plot was not changed.</source>
        <translation>これは描けません：%1。グラフは元のままです。</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 を保存しました。</translation>
    </message>
    <message>
        <source>Could not save %1: %2.</source>
        <translation>%1 を保存できませんでした：%2。</translation>
    </message>
    <message>
        <source>A surface has no curve to play.</source>
        <translation>曲面には鳴らす曲線がありません。</translation>
    </message>
    <message>
        <source>Sound is off. M: turn it on.</source>
        <translation>音は消してあります。M で音を出します。</translation>
    </message>
    <message>
        <source>Sound off.</source>
        <translation>音を消しました。</translation>
    </message>
    <message>
        <source>Sound on.</source>
        <translation>音を出します。</translation>
    </message>
    <message>
        <source>Could not open %1: %2. The plot was not changed.</source>
        <translation>%1 を開けませんでした：%2。グラフは元のままです。</translation>
    </message>
    <message>
        <source>Opened %1.</source>
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
        <source>“%1” is not a valid height range. The range was not changed.</source>
        <translation>「%1」は高さの範囲ではありません。範囲は変わっていません。</translation>
    </message>
    <message>
        <source>y = 0 is outside the range.</source>
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
    <message>
        <source>%1 = %2</source>
        <translation>%1 = %2</translation>
    </message>
    <message>
        <source>There is no plot to make a model of yet.</source>
        <translation>模型にするグラフがまだありません。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::GrooveCurve</name>
    <message>
        <source>Width along the stroke</source>
        <translation>画に沿った太さ</translation>
    </message>
    <message>
        <source>Depth along the stroke</source>
        <translation>画に沿った深さ</translation>
    </message>
    <message>
        <source>Drag a point up or down, or choose one with Left and Right and make it wider or thinner with Up and Down</source>
        <translation>点を上下にドラッグします。左右キーで点を選び、上下キーで太さを変えることもできます</translation>
    </message>
    <message>
        <source>Drag a point up or down, or choose one with Left and Right and make it shallower or deeper with Up and Down</source>
        <translation>点を上下にドラッグします。左右キーで点を選び、上下キーで深さを変えることもできます</translation>
    </message>
    <message>
        <source>No stroke is chosen.</source>
        <translation>画が選ばれていません。</translation>
    </message>
    <message numerus="yes">
        <source>%n points. Left and Right choose one.</source>
        <translation>
            <numerusform>点は%n個。左右キーで選びます。</numerusform>
        </translation>
    </message>
    <message>
        <source>Point %1 of %2: %3</source>
        <translation>点%1（全%2）：%3</translation>
    </message>
    <message>
        <source>depth %1%</source>
        <translation>深さ%1%</translation>
    </message>
    <message>
        <source>width %1</source>
        <translation>太さ%1</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深さ</translation>
    </message>
    <message>
        <source>Width</source>
        <translation>太さ</translation>
    </message>
    <message>
        <source>%1%</source>
        <translation>%1%</translation>
    </message>
</context>
<context>
    <name>nazori::ui::HardStrokesCard</name>
    <message>
        <source>Hardest strokes</source>
        <translation>苦手な画</translation>
    </message>
    <message>
        <source>No stroke has been wrong more than once. Those that are will appear here.</source>
        <translation>2回以上間違えた画はまだありません。あればここに並びます。</translation>
    </message>
    <message>
        <source>Strokes that were wrong more than once: %1. Enter: open the character.</source>
        <translation>2回以上間違えた画：%1。Enter で文字を開きます。</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>character, sentence</comment>
        <translation>%1：%2</translation>
    </message>
</context>
<context>
    <name>nazori::ui::Home</name>
    <message>
        <source>H&amp;ome</source>
        <translation>ホーム(&amp;O)</translation>
    </message>
    <message>
        <source>Today&apos;s reviews and new characters</source>
        <translation>今日の復習と新しい字</translation>
    </message>
    <message>
        <source>Enter: start. Each review is saved as soon as you rate it.</source>
        <translation>Enter で始めます。評価するとすぐに保存されます。</translation>
    </message>
    <message>
        <source>No reviews are due now.</source>
        <translation>今する復習はありません。</translation>
    </message>
    <message>
        <source>All characters of your lists are begun.</source>
        <translation>リストの文字はすべて学習を始めています。</translation>
    </message>
    <message>
        <source>There is nothing to review ahead.</source>
        <translation>先に復習できる文字はありません。</translation>
    </message>
    <message>
        <source>No character needs care now.</source>
        <translation>今、特に練習が必要な文字はありません。</translation>
    </message>
    <message>
        <source>Nothing was written from memory in this time.</source>
        <translation>この期間に見ないで書いた字はありません。</translation>
    </message>
    <message>
        <source>Picture of the month</source>
        <translation>今月の画像</translation>
    </message>
    <message>
        <source>Picture of the week</source>
        <translation>今週の画像</translation>
    </message>
    <message>
        <source>Picture (*.png)</source>
        <translation>画像 (*.png)</translation>
    </message>
    <message>
        <source>Saved: %1.</source>
        <translation>%1 を保存しました。</translation>
    </message>
    <message>
        <source>%1: %2. Nothing was saved.</source>
        <translation>%1：%2。保存していません。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::HomeActions</name>
    <message>
        <source>&amp;Start today&apos;s study</source>
        <translation>今日の学習を始める(&amp;S)</translation>
    </message>
    <message>
        <source>Start today&apos;s reviews and new characters</source>
        <translation>今日の復習と新しい字を始めます</translation>
    </message>
    <message>
        <source>Rele&amp;arn difficult characters</source>
        <translation>苦手な文字を覚え直す(&amp;A)</translation>
    </message>
    <message>
        <source>Relearn characters you forgot too often, starting with Watch</source>
        <translation>何度も忘れた文字を、「見る」からやり直します</translation>
    </message>
    <message>
        <source>Undo las&amp;t review</source>
        <translation>最後の復習を取り消す(&amp;T)</translation>
    </message>
    <message>
        <source>Undo the last saved review or change; repeat to go further back, even to earlier days</source>
        <translation>最後に保存した復習や変更を取り消します。繰り返すと、さらに前や別の日のものも取り消せます</translation>
    </message>
    <message>
        <source>Study se&amp;ttings…</source>
        <translation>学習の設定(&amp;T)…</translation>
    </message>
    <message>
        <source>Daily goal, lists, order and desired retention</source>
        <translation>1日の目標、リスト、順番、目標の定着率</translation>
    </message>
    <message>
        <source>St&amp;udy</source>
        <translation>学習(&amp;U)</translation>
    </message>
    <message>
        <source>Only &amp;reviews</source>
        <translation>復習だけする(&amp;R)</translation>
    </message>
    <message>
        <source>Start today&apos;s reviews without new characters</source>
        <translation>新しい字なしで、今日の復習だけを始めます</translation>
    </message>
    <message>
        <source>&amp;Five more new characters</source>
        <translation>新しい字をあと5字(&amp;F)</translation>
    </message>
    <message>
        <source>Learn five more new characters today, beyond your daily goal</source>
        <translation>1日の目標を超えて、今日あと5字を新しく学習します</translation>
    </message>
    <message>
        <source>Review a&amp;head</source>
        <translation>先に復習する(&amp;H)</translation>
    </message>
    <message>
        <source>Review the next characters before they are due, twenty at most</source>
        <translation>次に復習する文字を、期日より前に復習します（最大20字）</translation>
    </message>
    <message>
        <source>&amp;Practise what was hard</source>
        <translation>難しかった文字を練習する(&amp;P)</translation>
    </message>
    <message>
        <source>Write the characters that need care from memory once</source>
        <translation>練習が必要な文字を、見ないで1回ずつ書きます</translation>
    </message>
    <message>
        <source>&amp;Choose characters</source>
        <translation>文字を選ぶ(&amp;C)</translation>
    </message>
    <message>
        <source>Go to the Characters page</source>
        <translation>「文字」のページへ移ります</translation>
    </message>
    <message>
        <source>See all hand&amp;writing</source>
        <translation>書いた字をすべて見る(&amp;W)</translation>
    </message>
    <message>
        <source>Show everything you wrote on the last day, or one row of it</source>
        <translation>最後の学習日に書いた字を、すべて、または1行だけ表示します</translation>
    </message>
    <message>
        <source>Picture of the wee&amp;k…</source>
        <translation>今週の画像(&amp;K)…</translation>
    </message>
    <message>
        <source>Save what you wrote this week as a picture (PNG)</source>
        <translation>今週書いた字を画像（PNG）として保存します</translation>
    </message>
    <message>
        <source>Picture of the &amp;month…</source>
        <translation>今月の画像(&amp;M)…</translation>
    </message>
    <message>
        <source>Save what you wrote this month as a picture (PNG)</source>
        <translation>今月書いた字を画像（PNG）として保存します</translation>
    </message>
    <message>
        <source>Change &amp;what I learn…</source>
        <translation>学ぶ内容を変える(&amp;W)…</translation>
    </message>
    <message>
        <source>What you want to write, what you know already, and how long a day</source>
        <translation>書きたい文字、もう書ける文字、1日の時間</translation>
    </message>
    <message>
        <source>&amp;Write with the brush</source>
        <translation>筆で書く(&amp;W)</translation>
    </message>
    <message>
        <source>Review well known characters with the brush, on the page Brush</source>
        <translation>定着した文字を「筆」のページで復習します</translation>
    </message>
</context>
<context>
    <name>nazori::ui::HomeView</name>
    <message>
        <source>Today</source>
        <translation>今日</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>もう一度試す</translation>
    </message>
    <message>
        <source>Relearn these</source>
        <translation>これらの文字を覚え直す</translation>
    </message>
    <message>
        <source>Study settings…</source>
        <translation>学習の設定…</translation>
    </message>
    <message>
        <source>Continue the session</source>
        <translation>学習を続ける</translation>
    </message>
    <message>
        <source>Enter or Space: start</source>
        <translation>Enter またはスペースキーで始めます</translation>
    </message>
    <message numerus="yes">
        <source>%n characters were forgotten too often and taken out of reviews: %1</source>
        <translation>
            <numerusform>何度も忘れたため、%n字を復習から外しました：%1</numerusform>
        </translation>
    </message>
    <message>
        <source>Five more new characters</source>
        <translation>新しい字をあと5字</translation>
    </message>
    <message>
        <source>Review ahead</source>
        <translation>先に復習する</translation>
    </message>
    <message>
        <source>Choose characters</source>
        <translation>文字を選ぶ</translation>
    </message>
    <message>
        <source>On the way</source>
        <translation>これまでの歩み</translation>
    </message>
    <message>
        <source>New today</source>
        <translation>今日の新しい字</translation>
    </message>
    <message>
        <source>What you write from memory will appear here, in your own hand.</source>
        <translation>見ないで書いた字が、あなたの筆跡のままここに並びます。</translation>
    </message>
    <message>
        <source>Picture of the week…</source>
        <translation>今週の画像…</translation>
    </message>
    <message>
        <source>Picture of the month…</source>
        <translation>今月の画像…</translation>
    </message>
    <message>
        <source>Needs care</source>
        <translation>練習が必要な文字</translation>
    </message>
    <message>
        <source>One day off a week is fine; this week&apos;s is used.</source>
        <translation>週に1日休んでも途切れません（今週の休みは使用済み）。</translation>
    </message>
    <message>
        <source>One day off a week is fine.</source>
        <translation>週に1日休んでも途切れません。</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>始める</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <comment>work, time</comment>
        <translation>%1・%2</translation>
    </message>
    <message>
        <source>Only reviews, %1</source>
        <translation>復習だけ（%1）</translation>
    </message>
    <message>
        <source>Today, in your hand</source>
        <translation>今日書いた字</translation>
    </message>
    <message>
        <source>Yesterday, in your hand</source>
        <translation>昨日書いた字</translation>
    </message>
    <message>
        <source>%1, in your hand</source>
        <comment>a day</comment>
        <translation>%1に書いた字</translation>
    </message>
    <message>
        <source>Not right every time today.</source>
        <translation>今日はうまくいかないときがありました。</translation>
    </message>
    <message>
        <source>Practise these, %1</source>
        <translation>これらを練習する（%1）</translation>
    </message>
    <message>
        <source>Show less</source>
        <translation>1行だけ表示</translation>
    </message>
    <message>
        <source>See all</source>
        <translation>すべて見る</translation>
    </message>
    <message numerus="yes">
        <source>Write with the brush, %n characters</source>
        <translation>
            <numerusform>筆で書く、%n字</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::HomeWords</name>
    <message>
        <source>Good morning</source>
        <translation>おはようございます</translation>
    </message>
    <message>
        <source>Good afternoon</source>
        <translation>こんにちは</translation>
    </message>
    <message>
        <source>Good evening</source>
        <translation>こんばんは</translation>
    </message>
    <message numerus="yes">
        <source>%n days in a row</source>
        <translation>
            <numerusform>%n日連続</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n reviews</source>
        <translation>
            <numerusform>復習%n件</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n new characters</source>
        <translation>
            <numerusform>新しい字%n字</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 and %2</source>
        <comment>reviews and new characters</comment>
        <translation>%1と%2</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1分</translation>
    </message>
    <message>
        <source>All school kanji</source>
        <translation>常用漢字全体</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <comment>learned, of all</comment>
        <translation>%2字中%1字</translation>
    </message>
    <message numerus="yes">
        <source>about %n days</source>
        <translation>
            <numerusform>約%n日</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>about %n weeks</source>
        <translation>
            <numerusform>約%n週間</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>about %n months</source>
        <translation>
            <numerusform>約%nか月</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>about %n years</source>
        <translation>
            <numerusform>約%n年</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 written, %2 right</source>
        <translation>%1回書いて、%2回正解</translation>
    </message>
    <message>
        <source>%1 · %2</source>
        <comment>written and right, time</comment>
        <translation>%1・%2</translation>
    </message>
    <message numerus="yes">
        <source>Done for now. %n characters come back today, the first at %1.</source>
        <translation>
            <numerusform>ひとまず終わりです。あと%n字が今日もう一度出ます。最初は%1です。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Done for today: you have reached your daily limit. %n reviews will wait until tomorrow.</source>
        <translation>
            <numerusform>今日は終わりです。1日の上限に達しました。%n件の復習は明日にまわします。</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing to learn yet. In the study settings, choose lists and how many new characters you want per day.</source>
        <translation>まだ学習するものがありません。学習の設定で、リストと1日の新しい字の数を選んでください。</translation>
    </message>
    <message numerus="yes">
        <source>Done for today. %n reviews are due tomorrow.</source>
        <translation>
            <numerusform>今日は終わりです。明日は%n件の復習があります。</numerusform>
        </translation>
    </message>
    <message>
        <source>Done for today. Tomorrow: new characters, no reviews.</source>
        <translation>今日は終わりです。明日は新しい字だけで、復習はありません。</translation>
    </message>
    <message>
        <source>Done for today. Nothing is due tomorrow.</source>
        <translation>今日は終わりです。明日の分はありません。</translation>
    </message>
    <message numerus="yes">
        <source>%n reviews are waiting. No hurry: do %1 today, starting with the characters you know best.</source>
        <translation>
            <numerusform>復習が%n件たまっています。急がなくて大丈夫です。今日は%1件、よく覚えている文字から復習します。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>You will catch up in %n days, on %1. No new characters until then.</source>
        <translation>
            <numerusform>%n日で追いつきます（%1まで）。それまで新しい字は出ません。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n more reviews will wait for another day because of your daily limit.</source>
        <translation>
            <numerusform>あと%n件の復習は、1日の上限のため別の日にまわします。</numerusform>
        </translation>
    </message>
    <message>
        <source>You first watch each new character, then trace it, then write it with less and less help, and finally from memory. It comes back just before you would forget it.</source>
        <translation>新しい字は、まず見て、次になぞり、ガイドを減らしながら書き、最後は見ないで書きます。忘れそうになる少し前にまた出てきます。</translation>
    </message>
    <message>
        <source>Done.</source>
        <translation>修了しました。</translation>
    </message>
    <message>
        <source>Done in %1 at this pace.</source>
        <translation>このペースならあと%1です。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::InformationPanel</name>
    <message>
        <source>About the character</source>
        <translation>文字の情報</translation>
    </message>
    <message>
        <source>On&apos;yomi</source>
        <translation>音読み</translation>
    </message>
    <message>
        <source>Kun&apos;yomi</source>
        <translation>訓読み</translation>
    </message>
    <message>
        <source>Radical</source>
        <translation>部首</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>パーツ</translation>
    </message>
    <message>
        <source>Words</source>
        <translation>言葉</translation>
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
            <numerusform>%n画</numerusform>
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
        <source>No meaning given</source>
        <translation>意味の記載はありません</translation>
    </message>
    <message>
        <source>%1 here, %2 in the dictionary</source>
        <translation>ここでは%1、辞書では%2画</translation>
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
        <source>used in names</source>
        <translation>人名用</translation>
    </message>
    <message>
        <source>old JLPT level %1</source>
        <translation>旧日本語能力試験%1級</translation>
    </message>
    <message>
        <source>The kanji is read %1; %2 follows in kana (okurigana)</source>
        <translation>漢字の読みが「%1」、送り仮名が「%2」です</translation>
    </message>
    <message>
        <source>, a form of %1</source>
        <translation>（%1の形）</translation>
    </message>
    <message>
        <source>%1. Open this character</source>
        <translation>%1&#x3000;この文字を開く</translation>
    </message>
    <message>
        <source>newspaper frequency: no. %1</source>
        <translation>新聞での頻度%1位</translation>
    </message>
    <message>
        <source>Easily confused</source>
        <translation>間違えやすい文字</translation>
    </message>
    <message>
        <source>Read %1, as in %2 (%3)</source>
        <translation>読みは%1。例：%2（%3）</translation>
    </message>
    <message>
        <source>your own form instead of the published one</source>
        <translation>標準の字形の代わりに自作の字形を使用</translation>
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
    <name>nazori::ui::InkRow</name>
    <message>
        <source>Your handwriting: %1</source>
        <translation>書いた字：%1</translation>
    </message>
</context>
<context>
    <name>nazori::ui::InputWatch</name>
    <message>
        <source>You are writing with %1.</source>
        <translation>%1 で書いています。</translation>
    </message>
    <message>
        <source>You are writing with the pen.</source>
        <translation>ペンで書いています。</translation>
    </message>
    <message>
        <source>You are writing with your finger. A pen works better.</source>
        <translation>指で書いています。ペンのほうが書きやすいです。</translation>
    </message>
    <message>
        <source>You are writing with the mouse. Your pen tablet works better.</source>
        <translation>マウスで書いています。お持ちのペンタブレットのほうが書きやすいです。</translation>
    </message>
    <message>
        <source>You are writing with the mouse. A pen tablet works better.</source>
        <translation>マウスで書いています。ペンタブレットのほうが書きやすいです。</translation>
    </message>
    <message>
        <source>Pen</source>
        <translation>ペン</translation>
    </message>
    <message>
        <source>Finger</source>
        <translation>指</translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation>マウス</translation>
    </message>
</context>
<context>
    <name>nazori::ui::KeyListDialog</name>
    <message>
        <source>Keyboard and mouse</source>
        <translation>キーボードとマウス</translation>
    </message>
    <message>
        <source>On the tablet</source>
        <translation>文字板の上で</translation>
    </message>
    <message>
        <source>Press the stylus down</source>
        <translation>ペン先を下ろす</translation>
    </message>
    <message>
        <source>left button, pen tip</source>
        <translation>左ボタン、ペン先</translation>
    </message>
    <message>
        <source>Press deeper or more lightly</source>
        <translation>深く／浅く</translation>
    </message>
    <message>
        <source>wheel while pressing, or pen pressure</source>
        <translation>押したままホイール、筆圧</translation>
    </message>
    <message>
        <source>Turn and tilt</source>
        <translation>回す・傾ける</translation>
    </message>
    <message>
        <source>right button, or side button of the pen</source>
        <translation>右ボタン、ペンのサイドボタン</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>動かす</translation>
    </message>
    <message>
        <source>middle button, or Shift + right button</source>
        <translation>中ボタン、または Shift＋右ボタン</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>拡大／縮小</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>ホイール</translation>
    </message>
    <message>
        <source>Reset view</source>
        <translation>正面に戻す</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Home</translation>
    </message>
    <message>
        <source>Undo a stroke (Memory)</source>
        <translation>一画取り消す（見ないで書く）</translation>
    </message>
    <message>
        <source>eraser end of the pen</source>
        <translation>ペンの消しゴム側</translation>
    </message>
</context>
<context>
    <name>nazori::ui::KeyWriting</name>
    <message>
        <source>Stroke %1.</source>
        <translation>%1画目です。</translation>
    </message>
    <message>
        <source>Start of stroke %1.</source>
        <translation>%1画目の書き始めです。</translation>
    </message>
    <message>
        <source>End of stroke %1.</source>
        <translation>%1画目の終わりです。</translation>
    </message>
    <message>
        <source>Beside stroke %1.</source>
        <translation>%1画目から外れました。</translation>
    </message>
    <message>
        <source>Pen down.</source>
        <translation>ペンを下ろしました。</translation>
    </message>
    <message>
        <source>Pen up.</source>
        <translation>ペンを上げました。</translation>
    </message>
    <message>
        <source>%1% from the left, %2% from the top.</source>
        <translation>左から%1%、上から%2%です。</translation>
    </message>
    <message>
        <source>No stroke here: %1</source>
        <translation>ここに画はありません。%1</translation>
    </message>
    <message>
        <source>Stroke %1, %2% of its length: %3</source>
        <translation>%1画目の%2%の所です。%3</translation>
    </message>
    <message>
        <source>The keys no longer move the pen.</source>
        <translation>キーでペンを動かすのをやめました。</translation>
    </message>
    <message>
        <source>This is the edge.</source>
        <translation>ここが端です。</translation>
    </message>
    <message>
        <source>There are no strokes to go to.</source>
        <translation>移動先の画がありません。</translation>
    </message>
    <message>
        <source>The keys move the pen. Arrow keys: move. %1: pen down or up. %2: next start. %3: where.</source>
        <translation>キーでペンを動かします。矢印キー：動かす、%1：下ろす／上げる、%2：次の書き始め、%3：場所</translation>
    </message>
</context>
<context>
    <name>nazori::ui::KnownDialog</name>
    <message>
        <source>Text with the characters you know</source>
        <translation>知っている文字を含む文章</translation>
    </message>
    <message>
        <source>I know these</source>
        <translation>知っている文字を登録</translation>
    </message>
    <message>
        <source>Paste any text or list, from another program for example. Every kanji and kana in it counts as known.</source>
        <translation>文章やリストを貼り付けてください（ほかのアプリのものでもかまいません）。含まれる漢字とかなはすべて知っている文字になります。</translation>
    </message>
    <message>
        <source>Mark as known</source>
        <translation>知っている文字にする</translation>
    </message>
    <message>
        <source>From a file…</source>
        <translation>ファイルから…</translation>
    </message>
    <message>
        <source>Open a list</source>
        <translation>リストを開く</translation>
    </message>
    <message numerus="yes">
        <source>%Ln characters will be marked as known. What you have studied stays as it is.</source>
        <translation>
            <numerusform>%Ln字を知っている文字にします。学習済みの文字はそのままです。</numerusform>
        </translation>
    </message>
    <message>
        <source>You have studied all of these characters.</source>
        <translation>どの文字もすでに学習済みです。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::LearnerActions</name>
    <message>
        <source>S&amp;witch learner…</source>
        <translation>学習者の切り替え(&amp;W)…</translation>
    </message>
    <message>
        <source>Choose, add, rename or remove a learner</source>
        <translation>学習者を選ぶ、追加する、名前を変更する、一覧から外す</translation>
    </message>
    <message>
        <source>&amp;Back up now</source>
        <translation>今すぐバックアップ(&amp;B)</translation>
    </message>
    <message>
        <source>Make a backup now, in addition to the daily ones</source>
        <translation>毎日のバックアップとは別に、今すぐ作ります</translation>
    </message>
    <message>
        <source>&amp;Restore from a backup…</source>
        <translation>バックアップから復元(&amp;R)…</translation>
    </message>
    <message>
        <source>See your backups and restore one</source>
        <translation>バックアップの一覧から選んで復元します</translation>
    </message>
    <message>
        <source>&amp;Export everything…</source>
        <translation>すべて書き出す(&amp;E)…</translation>
    </message>
    <message>
        <source>Save the complete study history with handwriting, lists and tags to a file (JSON)</source>
        <translation>学習履歴、筆跡、リスト、タグをすべてファイルに保存します（JSON）</translation>
    </message>
    <message>
        <source>Export a &amp;table of reviews…</source>
        <translation>復習の表を書き出す(&amp;T)…</translation>
    </message>
    <message>
        <source>Save every entry as a row of a table (CSV)</source>
        <translation>書いた記録をすべて表に保存します（CSV）</translation>
    </message>
    <message>
        <source>Export for &amp;Anki…</source>
        <translation>Anki 用に書き出す(&amp;A)…</translation>
    </message>
    <message>
        <source>Save cards with stroke order, readings, meanings and words (.apkg)</source>
        <translation>書き順、読み、意味、言葉のカードを書き出します（.apkg）</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>読み込む(&amp;I)…</translation>
    </message>
    <message>
        <source>Load exported data (JSON), also from another computer</source>
        <translation>書き出したデータ（JSON）を読み込みます。ほかのパソコンのものも使えます</translation>
    </message>
    <message>
        <source>&amp;Learner</source>
        <translation>学習者(&amp;L)</translation>
    </message>
</context>
<context>
    <name>nazori::ui::LearnerMenu</name>
    <message>
        <source>All study data (*.json)</source>
        <translation>学習データ (*.json)</translation>
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
        <source>Nothing studied yet, so there is nothing to export.</source>
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
        <source>All study data (*.json);;All files (*)</source>
        <translation>学習データ (*.json);;すべてのファイル (*)</translation>
    </message>
</context>
<context>
    <name>nazori::ui::LearnerWords</name>
    <message>
        <source>The study data cannot be read: %1.</source>
        <translation>学習データを読めません：%1。</translation>
    </message>
    <message>
        <source>“%1” cannot be a learner name: use at most 60 letters (20 in Japanese), no “/”, and no dot at the start.</source>
        <translation>「%1」は学習者の名前に使えません。半角60文字（全角20文字）までで、「/」を含まず、点で始まらない名前にしてください。</translation>
    </message>
    <message>
        <source>There is no folder for study data: set NAZORI_LEARNERS. Nothing will be saved.</source>
        <translation>学習データの保存先がありません。NAZORI_LEARNERS を設定してください。何も保存されません。</translation>
    </message>
    <message>
        <source>Today&apos;s backup failed: %1. You can still study.</source>
        <translation>今日のバックアップを作れませんでした：%1。学習は続けられます。</translation>
    </message>
    <message>
        <source>The study data of %1 was written by a newer Nazori or by another program: %2. Nothing was changed, and nothing will be saved.</source>
        <translation>%1 の学習データは、新しい版の Nazori か別のプログラムのものです：%2。何も変更していません。何も保存されません。</translation>
    </message>
    <message>
        <source>The study data of %1 is damaged: %2. Nothing was changed. You can restore a backup.</source>
        <translation>%1 の学習データが壊れています：%2。何も変更していません。バックアップから復元できます。</translation>
    </message>
    <message>
        <source>The study data of %1 cannot be saved: %2. Nothing will be saved.</source>
        <translation>%1 の学習データに書き込めません：%2。何も保存されません。</translation>
    </message>
    <message>
        <source>Could not save: %1.</source>
        <translation>保存できませんでした：%1。</translation>
    </message>
    <message>
        <source>“%1” is now open here. Everything is saved again.</source>
        <translation>「%1」をここで開きました。すべて保存されます。</translation>
    </message>
    <message>
        <source>“%1” is open in another Nazori window. Close it there; until then nothing is saved here.</source>
        <translation>「%1」は別の Nazori のウィンドウで開いています。そちらを閉じてください。それまで、ここでは何も保存されません。</translation>
    </message>
    <message>
        <source>the disk is full. Free up some space; everything saved before is safe</source>
        <translation>ディスクがいっぱいです。空き容量を増やしてください。これまでに保存したものは無事です</translation>
    </message>
    <message>
        <source>there is no permission to write to %1. Check the permissions of the folder</source>
        <translation>%1 に書き込めません。フォルダーの権限を確かめてください</translation>
    </message>
    <message>
        <source>Every character of %1 is being worked out anew. Nothing is kept until that is done.</source>
        <translation>%1 のすべての漢字を計算し直しています。終わるまで、書いたものは保存されません。</translation>
    </message>
    <message>
        <source>The study data of %1 is being replaced. Nothing is saved until this is done.</source>
        <translation>%1 の学習データを置き換えています。終わるまで何も保存されません。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::LearnersDialog</name>
    <message>
        <source>Learners</source>
        <translation>学習者</translation>
    </message>
    <message>
        <source>&amp;Learners</source>
        <translation>学習者(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Name (to add or rename)</source>
        <translation>名前（追加・変更用）(&amp;N)</translation>
    </message>
    <message>
        <source>Name (to add or rename)</source>
        <translation>名前（追加・変更用）</translation>
    </message>
    <message>
        <source>&amp;Study as this learner</source>
        <translation>この学習者で学習(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation>追加(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>名前を変更(&amp;R)</translation>
    </message>
    <message>
        <source>Re&amp;move…</source>
        <translation>一覧から外す(&amp;M)…</translation>
    </message>
    <message>
        <source>Each learner has their own study history, settings and backups.</source>
        <translation>学習履歴、設定、バックアップは学習者ごとに分かれています。</translation>
    </message>
    <message>
        <source>✓ %1 (current)</source>
        <translation>✓ %1（現在）</translation>
    </message>
    <message>
        <source>Type a name first: at most 60 letters (20 in Japanese), no “/”, and no dot at the start.</source>
        <translation>まず名前を入力してください。半角60文字（全角20文字）までで、「/」を含まず、点で始まらない名前にしてください。</translation>
    </message>
    <message>
        <source>%1 already exists. Type another name.</source>
        <translation>%1 はすでにあります。ほかの名前にしてください。</translation>
    </message>
    <message>
        <source>Now studying as %1.</source>
        <translation>現在の学習者は %1 です。</translation>
    </message>
    <message>
        <source>%1 could not be renamed: %2.</source>
        <translation>%1 の名前を変更できませんでした：%2。</translation>
    </message>
    <message>
        <source>Renamed %1 to %2.</source>
        <translation>%1 の名前を %2 に変更しました。</translation>
    </message>
    <message>
        <source>Remove a learner</source>
        <translation>学習者を一覧から外す</translation>
    </message>
    <message>
        <source>Remove %1, with all reviews, handwriting and backups, from the list of learners?</source>
        <translation>%1 を、復習、筆跡、バックアップごと学習者の一覧から外しますか。</translation>
    </message>
    <message>
        <source>Nothing is deleted. The folder is moved to “.removed”, next to the other learners. Move it back to use it again.</source>
        <translation>何も削除されません。フォルダーは、ほかの学習者の隣の「.removed」に移ります。戻せばまた使えます。</translation>
    </message>
    <message>
        <source>Re&amp;move</source>
        <translation>一覧から外す(&amp;M)</translation>
    </message>
    <message>
        <source>Removed %1. The folder is now in %2.</source>
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
        <source>Search by character, by reading (kana or romaji) or by English meaning (Ctrl+F)</source>
        <translation>文字、読み（かな・ローマ字）、英語の意味で探せます（Ctrl+F）</translation>
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
        <source>Kanji for names</source>
        <translation>人名用漢字</translation>
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
        <translation>すべての文字</translation>
    </message>
    <message>
        <source>List of characters</source>
        <translation>文字の一覧</translation>
    </message>
    <message>
        <source>Characters in the list</source>
        <translation>一覧の文字</translation>
    </message>
    <message numerus="yes">
        <source>%n found</source>
        <translation>
            <numerusform>%n件</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters</source>
        <translation>
            <numerusform>%n字</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing found for “%1”. Try a character (休), a reading (やすむ, yasumu) or an English meaning (rest).</source>
        <translation>「%1」は見つかりませんでした。文字（休）、読み（やすむ、yasumu）、英語の意味（rest）で探してみてください。</translation>
    </message>
    <message>
        <source>Search results</source>
        <translation>検索結果</translation>
    </message>
    <message>
        <source>Search by strokes, radical, parts or code</source>
        <translation>画数、部首、パーツ、コードで探す</translation>
    </message>
    <message>
        <source>Parts…</source>
        <translation>パーツ…</translation>
    </message>
    <message>
        <source>Radical…</source>
        <translation>部首…</translation>
    </message>
    <message>
        <source>Number of strokes</source>
        <translation>画数</translation>
    </message>
    <message>
        <source>SKIP code</source>
        <translation>SKIP コード</translation>
    </message>
    <message>
        <source>Four-corner code</source>
        <translation>四角号碼</translation>
    </message>
    <message>
        <source>School grade</source>
        <translation>学年</translation>
    </message>
    <message>
        <source>Old JLPT level</source>
        <translation>旧 JLPT の級</translation>
    </message>
    <message>
        <source>The most frequent</source>
        <translation>よく使われる文字</translation>
    </message>
    <message>
        <source>My characters</source>
        <translation>自作の文字</translation>
    </message>
</context>
<context>
    <name>nazori::ui::ListChoice</name>
    <message>
        <source>Your lists and tags cannot be read: %1</source>
        <translation>自分のリストとタグを読めません：%1</translation>
    </message>
    <message>
        <source>Studied so far</source>
        <translation>これまでに学習した文字</translation>
    </message>
    <message>
        <source>Grade %1</source>
        <translation>小学%1年</translation>
    </message>
    <message>
        <source>Secondary school</source>
        <translation>中学以上（常用）</translation>
    </message>
    <message>
        <source>Kanji for names</source>
        <translation>人名用漢字</translation>
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
        <translation>旧日本語能力試験%1級（2009年まで）</translation>
    </message>
    <message>
        <source>My list: %1</source>
        <translation>自分のリスト：%1</translation>
    </message>
    <message>
        <source>Tag: %1</source>
        <translation>タグ：%1</translation>
    </message>
    <message>
        <source>My characters</source>
        <translation>自作の文字</translation>
    </message>
</context>
<context>
    <name>nazori::ui::MachineOptions</name>
    <message>
        <source>De&amp;pth of the grooves</source>
        <translation>溝の深さ(&amp;P)</translation>
    </message>
    <message>
        <source>C&amp;utter of the mill (.nc)</source>
        <translation>切削機の刃の直径（.nc）(&amp;U)</translation>
    </message>
    <message>
        <source>Depth of one p&amp;ass (.nc)</source>
        <translation>1回で削る深さ（.nc）(&amp;A)</translation>
    </message>
    <message>
        <source>La&amp;yers of the laser (.svg)</source>
        <translation>レーザーの層の数（.svg）(&amp;Y)</translation>
    </message>
    <message>
        <source>Swell pa&amp;per (.pdf)</source>
        <translation>立体コピー用紙（.pdf）(&amp;P)</translation>
    </message>
    <message>
        <source>A4</source>
        <translation>A4</translation>
    </message>
    <message>
        <source>B5</source>
        <translation>B5</translation>
    </message>
    <message>
        <source>Letter</source>
        <translation>レター</translation>
    </message>
    <message>
        <source>&amp;English braille</source>
        <translation>英語の点字(&amp;E)</translation>
    </message>
    <message>
        <source>Uncontracted</source>
        <translation>縮約なし</translation>
    </message>
    <message>
        <source>Contracted (UEB)</source>
        <translation>縮約あり（UEB）</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Dis&amp;tance between lines of the last pass (.nc)</source>
        <translation>仕上げの線の間隔（.nc）(&amp;T)</translation>
    </message>
    <message>
        <source>Sp&amp;eed along a groove (.nc)</source>
        <translation>溝に沿う送り速度（.nc）(&amp;E)</translation>
    </message>
    <message>
        <source> mm/min</source>
        <translation> mm/分</translation>
    </message>
    <message>
        <source>Speed straight do&amp;wn (.nc)</source>
        <translation>真下への送り速度（.nc）(&amp;W)</translation>
    </message>
    <message>
        <source>Height o&amp;f rapid moves (.nc)</source>
        <translation>早送りの高さ（.nc）(&amp;F)</translation>
    </message>
    <message>
        <source>Sp&amp;indle (.nc)</source>
        <translation>主軸の回転数（.nc）(&amp;I)</translation>
    </message>
    <message>
        <source> rpm</source>
        <translation> 回転/分</translation>
    </message>
    <message>
        <source>&amp;Cells in a line (.brf)</source>
        <translation>1行のマス数（.brf）(&amp;C)</translation>
    </message>
    <message>
        <source>Lines on a pa&amp;ge (.brf)</source>
        <translation>1ページの行数（.brf）(&amp;G)</translation>
    </message>
</context>
<context>
    <name>nazori::ui::MainWindow</name>
    <message>
        <source>The recording has ended. Writing %1.</source>
        <translation>記録を終えました。%1 を書き出しています。</translation>
    </message>
    <message>
        <source>The tablet cannot be shown: OpenGL 3.3 is missing. Install the package libgl1-mesa-dri, which works on any computer. Lists and character information still work.</source>
        <translation>OpenGL 3.3 がないため、文字板を表示できません。libgl1-mesa-dri パッケージを入れると、どのコンピューターでも表示できます。一覧と文字の情報は使えます。</translation>
    </message>
    <message>
        <source>Carved tablet</source>
        <translation>彫られた文字板</translation>
    </message>
    <message>
        <source>Settings could not be saved in %1. They apply until you close Nazori.</source>
        <translation>設定を %1 に保存できませんでした。Nazori を閉じるまでは有効です。</translation>
    </message>
    <message>
        <source>Kanji database: %1.</source>
        <translation>漢字データベース：%1。</translation>
    </message>
    <message>
        <source>The tablet cannot be shown: %1.</source>
        <translation>文字板を表示できません：%1。</translation>
    </message>
    <message>
        <source>The stylus does not work: %1.</source>
        <translation>ペンが使えません：%1。</translation>
    </message>
    <message>
        <source>%1 – Nazori</source>
        <translation>%1 – Nazori</translation>
    </message>
    <message>
        <source>Device changed: the recording continues in %1.</source>
        <translation>デバイスが替わったので、記録は %1 に続きます。</translation>
    </message>
    <message>
        <source>The recording %1 stopped: %2.</source>
        <translation>記録 %1 が止まりました：%2。</translation>
    </message>
    <message>
        <source>An interrupted recording was recovered: %1.</source>
        <translation>中断された記録を復元しました：%1。</translation>
    </message>
    <message>
        <source>A recording was cut off when the computer stopped. Its last second may be missing: %1.</source>
        <translation>コンピューターの停止で途切れた記録があります。最後の1秒が欠けているかもしれません：%1。</translation>
    </message>
    <message>
        <source>Volume %1%.</source>
        <translation>音量 %1%。</translation>
    </message>
    <message>
        <source>Recorded: %1.</source>
        <translation>記録しました：%1。</translation>
    </message>
    <message>
        <source>The recording is incomplete: %1.</source>
        <translation>記録は完全ではありません：%1。</translation>
    </message>
    <message>
        <source>Record pen motion</source>
        <translation>ペンの動きを記録</translation>
    </message>
    <message>
        <source>Recording for replay (*.nzr)</source>
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
        <source>Recording to %1. Press %2 to stop.</source>
        <translation>%1 に記録しています。%2 で停止します。</translation>
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
    <name>nazori::ui::MemoryView</name>
    <message>
        <source>Strictness: %1.</source>
        <translation>判定の厳しさ：%1。</translation>
    </message>
    <message>
        <source>Your writing beside the model. Space: replay both.</source>
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
# text after # is a comment</source>
        <translation>休日月火水木金土
# から行末まではメモです</translation>
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
        <source>Open a list</source>
        <translation>リストを開く</translation>
    </message>
    <message>
        <source>Text files (*.txt *.csv *.tsv);;All files (*)</source>
        <translation>テキストファイル (*.txt *.csv *.tsv);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Give the list a name of at most 100 letters (33 in Japanese).</source>
        <translation>リストに半角100文字（全角33文字）までの名前を付けてください。</translation>
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
    <name>nazori::ui::OwnNames</name>
    <message>
        <source>own character</source>
        <translation>自作の文字</translation>
    </message>
    <message>
        <source>“%1”</source>
        <translation>「%1」</translation>
    </message>
</context>
<context>
    <name>nazori::ui::PageRail</name>
    <message>
        <source>Pages</source>
        <translation>ページ</translation>
    </message>
</context>
<context>
    <name>nazori::ui::PaperView</name>
    <message>
        <source>Sheet of paper</source>
        <translation>紙</translation>
    </message>
</context>
<context>
    <name>nazori::ui::ParameterSliders</name>
    <message>
        <source>Parameter %1</source>
        <translation>パラメーター %1</translation>
    </message>
    <message>
        <source>%1 from %2 to %3. Left and Right: one step. Page Up and Page Down: ten steps</source>
        <translation>%1 は %2 から %3 まで。左右キーで 1 目盛り、Page Up と Page Down で 10 目盛り動きます</translation>
    </message>
    <message>
        <source>%1 = %2</source>
        <translation>%1 = %2</translation>
    </message>
</context>
<context>
    <name>nazori::ui::PartWords</name>
    <message>
        <source>No name yet</source>
        <translation>名前なし</translation>
    </message>
    <message>
        <source>%1: no strokes</source>
        <translation>%1：画なし</translation>
    </message>
    <message numerus="yes">
        <source>%1: strokes %2</source>
        <translation>
            <numerusform>%1：%2画目</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::PartsEditor</name>
    <message>
        <source>Parts</source>
        <translation>パーツ</translation>
    </message>
    <message>
        <source>Name of the part</source>
        <translation>パーツの名前</translation>
    </message>
    <message>
        <source>Strokes of the part</source>
        <translation>パーツの画</translation>
    </message>
    <message>
        <source>1, 2 or 1-3</source>
        <translation>1, 2 または 1-3</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>画</translation>
    </message>
    <message>
        <source>There are no strokes yet.</source>
        <translation>まだ画がありません。</translation>
    </message>
    <message>
        <source>“%1” does not name strokes. Type numbers from 1 to %2: 1, 2 or 1-3.</source>
        <translation>「%1」は画の番号ではありません。1から%2までの番号を入力してください（1, 2 または 1-3）。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::PeriodPicture</name>
    <message>
        <source>Week of %1</source>
        <translation>%1からの1週間</translation>
    </message>
    <message numerus="yes">
        <source>%n characters in my own hand</source>
        <translation>
            <numerusform>自分の手で書いた字：%n字</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n new</source>
        <translation>
            <numerusform>新しい字：%n字</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n study days</source>
        <translation>
            <numerusform>学習日数：%n日</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::PlotDialog</name>
    <message>
        <source>Expression</source>
        <translation>式</translation>
    </message>
    <message>
        <source>Drawing</source>
        <translation>描画</translation>
    </message>
    <message>
        <source>A function plot</source>
        <translation>関数のグラフ</translation>
    </message>
    <message>
        <source>&amp;Expression</source>
        <translation>式(&amp;E)</translation>
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
        <source>&amp;Make the relief</source>
        <translation>彫る(&amp;M)</translation>
    </message>
    <message>
        <source>This cannot be drawn: %1.</source>
        <translation>描けません：%1。</translation>
    </message>
    <message>
        <source>“%1” is not a number.</source>
        <translation>「%1」は数ではありません。</translation>
    </message>
    <message>
        <source>This range cannot be shown: %1.</source>
        <translation>この範囲は表示できません：%1。</translation>
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
        <source>Fra&amp;me</source>
        <translation>枠(&amp;M)</translation>
    </message>
    <message>
        <source>Soun&amp;d off</source>
        <translation>消音(&amp;D)</translation>
    </message>
    <message>
        <source>Expression and range</source>
        <translation>式と範囲</translation>
    </message>
    <message>
        <source>Expression</source>
        <translation>式</translation>
    </message>
    <message>
        <source>Separate several expressions with semicolons. Up and Down: earlier expressions</source>
        <translation>複数の式はセミコロンで区切ります。上下の矢印キーで以前の式を呼び出します</translation>
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
        <source>Show on the plot</source>
        <translation>グラフに表示</translation>
    </message>
    <message>
        <source>Groove width in millimetres</source>
        <translation>溝の幅（ミリメートル）</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>Groo&amp;ve width</source>
        <translation>溝の幅(&amp;V)</translation>
    </message>
    <message>
        <source>Samples per side</source>
        <translation>1辺のサンプル数</translation>
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
        <source>z from</source>
        <translation>z の下限</translation>
    </message>
    <message>
        <source>z to</source>
        <translation>z の上限</translation>
    </message>
    <message>
        <source>Height range of a surface; leave empty to fit its values</source>
        <translation>曲面の高さの範囲。空欄なら値に合わせます</translation>
    </message>
    <message>
        <source>Range</source>
        <translation>範囲</translation>
    </message>
</context>
<context>
    <name>nazori::ui::PlotText</name>
    <message>
        <source>Column %1: %2; %3.</source>
        <translation>%1文字目：%2。%3。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::PointsPanel</name>
    <message>
        <source>Points of &amp;interest</source>
        <translation>注目点(&amp;I)</translation>
    </message>
    <message>
        <source>None in this range.</source>
        <translation>この範囲にはありません。</translation>
    </message>
    <message>
        <source>The drawing was stopped before the points of interest were found.</source>
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
        <source>Type</source>
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
        <translation>学習の記録(&amp;R)</translation>
    </message>
    <message>
        <source>Your progress in charts and numbers</source>
        <translation>学習の成果をグラフと数値で見ます</translation>
    </message>
    <message>
        <source>Progress of %1</source>
        <translation>%1 の学習の記録</translation>
    </message>
    <message>
        <source>All data is shown.</source>
        <translation>すべての期間を表示しています。</translation>
    </message>
    <message>
        <source>One month is the shortest period.</source>
        <translation>最短の期間は1か月です。</translation>
    </message>
    <message>
        <source>1 to %1 go to a chart, N shows its numbers, Ctrl+C copies them.</source>
        <translation>1～%1 でグラフへ、N で数字を表示、Ctrl+C でコピー。</translation>
    </message>
    <message>
        <source>%1: no data yet.</source>
        <translation>%1：まだデータがありません。</translation>
    </message>
    <message>
        <source>Copied “%1” (rows: %2).</source>
        <translation>「%1」の数値をコピーしました（%2行）。</translation>
    </message>
    <message>
        <source>No stroke has been wrong more than once.</source>
        <translation>2回以上間違えた画はありません。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::ProgressActions</name>
    <message>
        <source>Characters by str&amp;ength</source>
        <translation>文字ごとの定着度(&amp;E)</translation>
    </message>
    <message>
        <source>Go to the grid of characters</source>
        <translation>文字の一覧へ移ります</translation>
    </message>
    <message>
        <source>&amp;Hardest strokes</source>
        <translation>苦手な画(&amp;H)</translation>
    </message>
    <message>
        <source>Go to the strokes you get wrong most often</source>
        <translation>よく間違える画へ移ります</translation>
    </message>
    <message>
        <source>&amp;Numbers or chart</source>
        <translation>数値とグラフの切り替え(&amp;N)</translation>
    </message>
    <message>
        <source>Switch the current chart between numbers and drawing</source>
        <translation>今のグラフを数値の表に、または図に切り替えます</translation>
    </message>
    <message>
        <source>Co&amp;py numbers</source>
        <translation>数値をコピー(&amp;P)</translation>
    </message>
    <message>
        <source>Copy the numbers of the current chart</source>
        <translation>今のグラフの数値をコピーします</translation>
    </message>
    <message>
        <source>&amp;Longer period</source>
        <translation>長い期間(&amp;L)</translation>
    </message>
    <message>
        <source>Show a longer period</source>
        <translation>もっと長い期間を表示します</translation>
    </message>
    <message>
        <source>Shor&amp;ter period</source>
        <translation>短い期間(&amp;T)</translation>
    </message>
    <message>
        <source>Show a shorter period</source>
        <translation>もっと短い期間を表示します</translation>
    </message>
    <message>
        <source>&amp;Progress</source>
        <translation>学習の記録(&amp;P)</translation>
    </message>
    <message>
        <source>C&amp;alendar</source>
        <translation>学習カレンダー(&amp;A)</translation>
    </message>
    <message>
        <source>Go to the calendar of the year</source>
        <translation>1年の学習カレンダーへ移ります</translation>
    </message>
    <message>
        <source>M&amp;ore charts and figures</source>
        <translation>詳しいグラフと数値(&amp;O)</translation>
    </message>
    <message>
        <source>Show or hide the charts</source>
        <translation>グラフを表示または非表示にします</translation>
    </message>
    <message>
        <source>Practise the hardest &amp;strokes</source>
        <translation>よく間違える画を練習する(&amp;S)</translation>
    </message>
    <message>
        <source>Write the characters of the hardest strokes from memory once</source>
        <translation>よく間違える画のある文字を、見ないで1回ずつ書きます</translation>
    </message>
</context>
<context>
    <name>nazori::ui::ProgressView</name>
    <message>
        <source>Progress</source>
        <translation>学習の記録</translation>
    </message>
    <message>
        <source>Period s&amp;hown</source>
        <translation>期間(&amp;H)</translation>
    </message>
    <message>
        <source>Period shown</source>
        <translation>期間</translation>
    </message>
    <message>
        <source>1 month</source>
        <translation>1か月</translation>
    </message>
    <message>
        <source>3 months</source>
        <translation>3か月</translation>
    </message>
    <message>
        <source>1 year</source>
        <translation>1年</translation>
    </message>
    <message>
        <source>All time</source>
        <translation>全期間</translation>
    </message>
    <message>
        <source>Calculating statistics</source>
        <translation>学習履歴を集計しています</translation>
    </message>
    <message>
        <source>Nothing studied yet. Start with a few characters on Home, or trace one on the Characters page. Your progress will appear here in charts and tables.</source>
        <translation>まだ何も学習していません。ホームで数文字から始めるか、「文字」のページで1字なぞってみてください。学習の記録がここにグラフと表で並びます。</translation>
    </message>
    <message>
        <source>Days in a row: %1, longest %2%3</source>
        <translation>連続日数：%1日、最長%2日%3</translation>
    </message>
    <message>
        <source>; not yet today</source>
        <translation>（今日はこれから）</translation>
    </message>
    <message>
        <source>; day off used this week</source>
        <translation>（今週の休みは使用済み）</translation>
    </message>
    <message>
        <source>Reviews: %1 in %2</source>
        <translation>復習：%1回、%2</translation>
    </message>
    <message>
        <source>Recall in the last 30 days: %1 of %2 reviews (predicted: %3)</source>
        <translation>思い出せた割合（過去30日間）：復習%2回で%1、予測%3</translation>
    </message>
    <message>
        <source>Characters: %1 studied, %2 learned</source>
        <translation>文字：学習した字 %1、身についた字 %2</translation>
    </message>
    <message>
        <source>Write these characters from memory once (P)</source>
        <translation>これらの文字を、見ないで1回ずつ書きます（P）</translation>
    </message>
    <message>
        <source>Practise these, %1</source>
        <translation>これらを練習する（%1）</translation>
    </message>
    <message>
        <source>Less: hide the charts</source>
        <translation>グラフを隠す</translation>
    </message>
    <message>
        <source>More charts and figures</source>
        <translation>詳しいグラフと数値を表示</translation>
    </message>
    <message>
        <source>Show or hide the charts (M)</source>
        <translation>グラフを表示または非表示にします（M）</translation>
    </message>
    <message>
        <source>%1 school kanji</source>
        <comment>405 of 2,136</comment>
        <translation>常用漢字 %1</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <comment>list, 40 of 46</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>%1: %2, at this pace done in %3.</source>
        <translation>%1：%2。このペースならあと%3です。</translation>
    </message>
    <message>
        <source>%1: %2.</source>
        <comment>list, 40 of 46</comment>
        <translation>%1：%2。</translation>
    </message>
    <message>
        <source>At this pace, all of them in %1.</source>
        <translation>このペースなら、全部であと%1です。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::QuestionView</name>
    <message>
        <source>Question</source>
        <translation>問題</translation>
    </message>
    <message>
        <source>looks like</source>
        <translation>似ている字</translation>
    </message>
    <message>
        <source>This is not the character you are being asked for.</source>
        <translation>これは今の問題の文字ではありません。</translation>
    </message>
    <message>
        <source> blank </source>
        <translation>（空欄）</translation>
    </message>
    <message numerus="yes">
        <source>a character with %n strokes</source>
        <translation>
            <numerusform>%n画の文字</numerusform>
        </translation>
    </message>
    <message>
        <source>Suggested: %1 (%2)</source>
        <translation>おすすめ：%1（%2）</translation>
    </message>
</context>
<context>
    <name>nazori::ui::SaveDialog</name>
    <message>
        <source>Save the tablet</source>
        <translation>文字板を保存</translation>
    </message>
    <message>
        <source>Height map, 8-bit RAW (2005 format)</source>
        <translation>高さマップ（8ビット RAW、2005年版の形式）</translation>
    </message>
    <message>
        <source>Height map, 16-bit PNG</source>
        <translation>高さマップ（16ビット PNG）</translation>
    </message>
    <message>
        <source>Stroke order, .str (2005 format)</source>
        <translation>書き順（.str、2005年版の形式）</translation>
    </message>
    <message>
        <source>%1 × %1 (2005 format)</source>
        <translation>%1 × %1（2005年版の形式）</translation>
    </message>
    <message>
        <source>Choose file…</source>
        <translation>ファイルを選ぶ…</translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation>形式(&amp;F)</translation>
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
        <source>Stroke order files (*.str)</source>
        <translation>書き順 (*.str)</translation>
    </message>
    <message>
        <source>%1 × %1</source>
        <translation>%1 × %1</translation>
    </message>
</context>
<context>
    <name>nazori::ui::SearchWords</name>
    <message>
        <source>in names: %1</source>
        <translation>名前での読み：%1</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes</source>
        <translation>
            <numerusform>%n画</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::SessionActions</name>
    <message>
        <source>&amp;Start today&apos;s study</source>
        <translation>今日の学習を始める(&amp;S)</translation>
    </message>
    <message>
        <source>Start today&apos;s reviews and new characters</source>
        <translation>今日の復習と新しい字を始めます</translation>
    </message>
    <message>
        <source>&amp;Next</source>
        <translation>次へ(&amp;N)</translation>
    </message>
    <message>
        <source>Go to the next stage, or accept the suggested rating</source>
        <translation>次の段階へ進みます。評価のときは、おすすめの評価を付けます</translation>
    </message>
    <message>
        <source>&amp;Again</source>
        <translation>もう一度(&amp;A)</translation>
    </message>
    <message>
        <source>Forgotten: comes back soon</source>
        <translation>忘れていた。まもなくまた出ます</translation>
    </message>
    <message>
        <source>&amp;Hard</source>
        <translation>難しい(&amp;H)</translation>
    </message>
    <message>
        <source>Remembered with effort</source>
        <translation>苦労して思い出した</translation>
    </message>
    <message>
        <source>Goo&amp;d</source>
        <translation>できた(&amp;D)</translation>
    </message>
    <message>
        <source>Remembered</source>
        <translation>思い出した</translation>
    </message>
    <message>
        <source>&amp;Easy</source>
        <translation>簡単(&amp;E)</translation>
    </message>
    <message>
        <source>Remembered easily</source>
        <translation>楽に思い出した</translation>
    </message>
    <message>
        <source>Undo las&amp;t review</source>
        <translation>最後の復習を取り消す(&amp;T)</translation>
    </message>
    <message>
        <source>Undo the last saved review or change; repeat to go further back, even to earlier days</source>
        <translation>最後に保存した復習や変更を取り消します。繰り返すと、さらに前や別の日のものも取り消せます</translation>
    </message>
    <message>
        <source>&amp;Postpone to tomorrow</source>
        <translation>明日に延期(&amp;P)</translation>
    </message>
    <message>
        <source>Show this character tomorrow instead</source>
        <translation>この文字を明日に延期します</translation>
    </message>
    <message>
        <source>S&amp;uspend or resume</source>
        <translation>休止・再開(&amp;U)</translation>
    </message>
    <message>
        <source>A suspended character does not come up until you resume it</source>
        <translation>休止した文字は、再開するまで出ません</translation>
    </message>
    <message>
        <source>Start &amp;over</source>
        <translation>最初からやり直す(&amp;O)</translation>
    </message>
    <message>
        <source>Treat this character as new again</source>
        <translation>この文字を新しい字に戻します</translation>
    </message>
    <message>
        <source>&amp;Tags…</source>
        <translation>タグ(&amp;T)…</translation>
    </message>
    <message>
        <source>Your own labels for this character; you can study by tag</source>
        <translation>この文字に自分のタグを付けます。タグごとに学習できます</translation>
    </message>
    <message>
        <source>End the &amp;session</source>
        <translation>学習を終える(&amp;S)</translation>
    </message>
    <message>
        <source>Everything you rated is saved</source>
        <translation>評価したものは保存されています</translation>
    </message>
    <message>
        <source>Study se&amp;ttings…</source>
        <translation>学習の設定(&amp;T)…</translation>
    </message>
    <message>
        <source>Daily goal, lists, order and desired retention</source>
        <translation>1日の目標、リスト、順番、目標の定着率</translation>
    </message>
    <message>
        <source>St&amp;udy</source>
        <translation>学習(&amp;U)</translation>
    </message>
    <message>
        <source>St&amp;udy this</source>
        <translation>この字を学ぶ(&amp;U)</translation>
    </message>
    <message>
        <source>Learn this character now; it then comes back in reviews</source>
        <translation>今この字を学びます。その後は復習で出てきます</translation>
    </message>
    <message>
        <source>I &amp;know this</source>
        <translation>もう知っている(&amp;K)</translation>
    </message>
    <message>
        <source>Skip the lesson: the character comes in a review after about a week</source>
        <translation>レッスンを省きます。約1週間後に復習で出てきます</translation>
    </message>
    <message>
        <source>Add to &amp;list…</source>
        <translation>リストに加える(&amp;L)…</translation>
    </message>
    <message>
        <source>Put this character into one of your own lists</source>
        <translation>この字を自分のリストに入れます</translation>
    </message>
    <message>
        <source>Change &amp;what I learn…</source>
        <translation>学ぶ内容を変える(&amp;W)…</translation>
    </message>
    <message>
        <source>What you want to write, what you know already, and how long a day</source>
        <translation>書きたい文字、もう書ける文字、1日の時間</translation>
    </message>
</context>
<context>
    <name>nazori::ui::SessionAnswers</name>
    <message>
        <source>Next step</source>
        <translation>次の操作</translation>
    </message>
    <message>
        <source>%1: %2, suggested</source>
        <translation>%1：%2、おすすめ</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Finish  ⏎</source>
        <translation>判定  ⏎</translation>
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
    <name>nazori::ui::SessionBar</name>
    <message>
        <source>Study session</source>
        <translation>今日の学習</translation>
    </message>
    <message>
        <source>Session progress</source>
        <translation>学習の進み具合</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>取り消す</translation>
    </message>
    <message>
        <source>More for this character</source>
        <translation>この文字のメニュー</translation>
    </message>
    <message>
        <source>%1 of %2</source>
        <translation>%1／%2</translation>
    </message>
    <message>
        <source>almost done</source>
        <translation>もうすぐ終わり</translation>
    </message>
    <message numerus="yes">
        <source>%n min left</source>
        <translation>
            <numerusform>残り%n分</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::SessionPanel</name>
    <message>
        <source>Character being studied</source>
        <translation>学習中の文字</translation>
    </message>
    <message>
        <source>Earlier writing</source>
        <translation>前に書いたもの</translation>
    </message>
    <message>
        <source>Again today</source>
        <translation>今日もう一度</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>復習</translation>
    </message>
    <message>
        <source>Not yet written from memory.</source>
        <translation>まだ見ないで書いたことがありません。</translation>
    </message>
    <message numerus="yes">
        <source>Written from memory: %n times</source>
        <translation>
            <numerusform>見ないで書いた回数：%n回</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Forgotten: %n times</source>
        <translation>
            <numerusform>忘れた回数：%n回</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Stroke %1 was wrong %n times.</source>
        <translation>
            <numerusform>%1画目を%n回間違えました。</numerusform>
        </translation>
    </message>
    <message>
        <source>now</source>
        <translation>今</translation>
    </message>
    <message>
        <source>Parts: %1.</source>
        <translation>パーツ：%1</translation>
    </message>
    <message>
        <source>Relearning: forgotten too often</source>
        <translation>覚え直し：苦手な文字</translation>
    </message>
    <message>
        <source>New</source>
        <translation>新しい字</translation>
    </message>
</context>
<context>
    <name>nazori::ui::SessionWords</name>
    <message>
        <source>Today&apos;s study could not be prepared: %1.</source>
        <translation>今日の学習を準備できませんでした：%1。</translation>
    </message>
    <message>
        <source>Nothing is due now.</source>
        <translation>今学習するものはありません。</translation>
    </message>
    <message>
        <source>Session ended. Everything you rated is saved.</source>
        <translation>学習を終えました。評価したものはすべて保存されています。</translation>
    </message>
    <message>
        <source>%1 was forgotten too often and taken out of reviews. Relearn it from Home.</source>
        <translation>「%1」は何度も忘れたので、復習から外しました。ホームで覚え直せます。</translation>
    </message>
    <message>
        <source>Saved: %1, %2. Next review %3.</source>
        <translation>保存しました：%1、%2。次の復習は%3です。</translation>
    </message>
    <message>
        <source>Nothing to undo.</source>
        <translation>取り消すものはありません。</translation>
    </message>
    <message>
        <source>Undone: the last entry for %1.</source>
        <translation>取り消しました：最後に書いた「%1」。</translation>
    </message>
    <message>
        <source>Undone: %1 is no longer postponed.</source>
        <translation>取り消しました：「%1」の延期をやめました。</translation>
    </message>
    <message>
        <source>Undone: %1 is no longer suspended.</source>
        <translation>取り消しました：「%1」の休止をやめました。</translation>
    </message>
    <message>
        <source>Undone: %1 is suspended again.</source>
        <translation>取り消しました：「%1」をまた休止しました。</translation>
    </message>
    <message>
        <source>Undone: your progress with %1 is back.</source>
        <translation>取り消しました：「%1」の学習が元に戻りました。</translation>
    </message>
    <message>
        <source>Undone: %1.</source>
        <translation>取り消しました：%1。</translation>
    </message>
    <message>
        <source>%1 Ctrl+Shift+Z: undo.</source>
        <translation>%1Ctrl+Shift+Z で取り消せます。</translation>
    </message>
    <message>
        <source>Postponed %1 to tomorrow.</source>
        <translation>「%1」を明日に延期しました。</translation>
    </message>
    <message>
        <source>Suspended %1 until you resume it.</source>
        <translation>「%1」を再開するまで休止します。</translation>
    </message>
    <message>
        <source>Started %1 over as a new character.</source>
        <translation>「%1」を新しい字に戻しました。</translation>
    </message>
    <message>
        <source>All done for now. Everything is saved.</source>
        <translation>今の分はこれで終わりです。すべて保存されています。</translation>
    </message>
    <message>
        <source>Undone: what you chose to learn.</source>
        <translation>取り消しました：学ぶ内容の選択。</translation>
    </message>
    <message numerus="yes">
        <source>Undone: what you chose to learn, and %n characters marked as known.</source>
        <translation>
            <numerusform>取り消しました：学ぶ内容の選択と、%n字に付けた「書ける」の印。</numerusform>
        </translation>
    </message>
    <message>
        <source>Undone: %1 is no longer marked as known.</source>
        <translation>取り消しました：%1 に付けた「書ける」の印。</translation>
    </message>
    <message>
        <source>No character is due with the brush now.</source>
        <translation>今、筆で復習する文字はありません。</translation>
    </message>
    <message>
        <source>All done with the brush for now. Every rating is saved.</source>
        <translation>筆での復習はひとまず終わりです。評価はすべて保存されています。</translation>
    </message>
    <message>
        <source>Saved: %1 with the brush, %2. Next time with the brush %3.</source>
        <translation>保存しました：%1（筆）、%2。次に筆で書くのは%3です。</translation>
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
        <source>Settings saved.</source>
        <translation>設定を保存しました。</translation>
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
    <name>nazori::ui::SheetCheckDialog</name>
    <message>
        <source>Photograph</source>
        <translation>写真</translation>
    </message>
    <message>
        <source>Cells that need care</source>
        <translation>気をつけたいます</translation>
    </message>
    <message>
        <source>The photograph with its cells</source>
        <translation>ますの付いた写真</translation>
    </message>
    <message>
        <source>Check worksheets</source>
        <translation>プリントを判定</translation>
    </message>
    <message>
        <source>Stroke order and direction cannot be seen in a photograph.</source>
        <translation>写真では書き順と画の向きは分かりません。</translation>
    </message>
    <message>
        <source>&amp;Open photographs…</source>
        <translation>写真を開く(&amp;O)…</translation>
    </message>
    <message>
        <source>&amp;Save the picture…</source>
        <translation>画像を保存(&amp;S)…</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 を保存しました。</translation>
    </message>
    <message numerus="yes">
        <source>Reading %n photographs…</source>
        <translation>
            <numerusform>写真%n枚を読み取っています…</numerusform>
        </translation>
    </message>
    <message>
        <source>Open photographs of worksheets</source>
        <translation>プリントの写真を開く</translation>
    </message>
    <message>
        <source>Photographs and scans (*.jpg *.jpeg *.png)</source>
        <translation>写真とスキャン (*.jpg *.jpeg *.png)</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>画像を保存</translation>
    </message>
    <message>
        <source>Picture (*.png)</source>
        <translation>画像 (*.png)</translation>
    </message>
    <message>
        <source>%1 checked</source>
        <translation>%1 判定済み</translation>
    </message>
</context>
<context>
    <name>nazori::ui::SheetWords</name>
    <message>
        <source>too small</source>
        <translation>小さすぎます</translation>
    </message>
    <message>
        <source>too large</source>
        <translation>大きすぎます</translation>
    </message>
    <message>
        <source>too high</source>
        <translation>上に寄りすぎています</translation>
    </message>
    <message>
        <source>too low</source>
        <translation>下に寄りすぎています</translation>
    </message>
    <message>
        <source>too far left</source>
        <translation>左に寄りすぎています</translation>
    </message>
    <message>
        <source>too far right</source>
        <translation>右に寄りすぎています</translation>
    </message>
    <message>
        <source>leans to the left</source>
        <translation>左に傾いています</translation>
    </message>
    <message>
        <source>leans to the right</source>
        <translation>右に傾いています</translation>
    </message>
    <message>
        <source>stroke %1 is missing</source>
        <translation>%1画目がありません</translation>
    </message>
    <message>
        <source>stroke %1 is too short</source>
        <translation>%1画目が短すぎます</translation>
    </message>
    <message>
        <source>has ink that belongs to no stroke</source>
        <translation>どの画でもない線があります</translation>
    </message>
    <message>
        <source>Quiz, page %1:</source>
        <translation>小テスト、%1ページ：</translation>
    </message>
    <message>
        <source>Practice sheet, page %1:</source>
        <translation>練習プリント、%1ページ：</translation>
    </message>
    <message numerus="yes">
        <source>%n cells, </source>
        <translation>
            <numerusform>%nます、</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 legible, %2 not legible, %3 empty.</source>
        <translation>読める字%1、読めない字%2、空のます%3。</translation>
    </message>
    <message>
        <source>not legible, looks like %1</source>
        <translation>読めません（%1に見えます）</translation>
    </message>
    <message>
        <source>not legible</source>
        <translation>読めません</translation>
    </message>
    <message>
        <source>legible</source>
        <translation>読めます</translation>
    </message>
    <message>
        <source>, </source>
        <translation>、</translation>
    </message>
    <message>
        <source>Cell %1, %2: %3</source>
        <translation>%1ます目、%2：%3</translation>
    </message>
</context>
<context>
    <name>nazori::ui::SolidDialog</name>
    <message>
        <source>Lines</source>
        <translation>線</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大きさ</translation>
    </message>
    <message>
        <source>Stroke &amp;numbers in braille</source>
        <translation>書き順の番号を点字で(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Dots where strokes start</source>
        <translation>書き始めの点(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Hole to hang it up</source>
        <translation>つり下げる穴(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Mould, to cast several</source>
        <translation>型（何枚も作るとき）(&amp;M)</translation>
    </message>
    <message>
        <source>The model from above</source>
        <translation>上から見た模型</translation>
    </message>
    <message>
        <source>Make a model to touch: %1</source>
        <translation>触れる模型を作る：%1</translation>
    </message>
    <message>
        <source>Raised, for fingers</source>
        <translation>浮き出し（指用）</translation>
    </message>
    <message>
        <source>Grooves, for a stylus</source>
        <translation>溝（ペン用）</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>&amp;Lines</source>
        <translation>線(&amp;L)</translation>
    </message>
    <message>
        <source>Si&amp;ze of the square</source>
        <translation>正方形の大きさ(&amp;Z)</translation>
    </message>
    <message>
        <source>&amp;Save…</source>
        <translation>保存(&amp;S)…</translation>
    </message>
    <message>
        <source>There is no model: %1.</source>
        <translation>模型を作れません：%1。</translation>
    </message>
    <message>
        <source>Saved as %1.</source>
        <translation>%1 に保存しました。</translation>
    </message>
    <message>
        <source>%1: %2. Nothing was saved.</source>
        <translation>%1：%2。何も保存していません。</translation>
    </message>
    <message>
        <source>Making the model…</source>
        <translation>模型を作成中…</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 mm</source>
        <translation>%1 × %2 × %3 mm</translation>
    </message>
    <message>
        <source>%1 triangles</source>
        <translation>三角形%1個</translation>
    </message>
    <message>
        <source>watertight</source>
        <translation>すき間なし</translation>
    </message>
    <message>
        <source>not watertight</source>
        <translation>すき間あり</translation>
    </message>
    <message>
        <source>No room for the numbers of strokes %1: a larger model has more.</source>
        <translation>%1画目の番号を置く場所がありません。大きくすると置けます。</translation>
    </message>
    <message>
        <source>Save the model</source>
        <translation>模型を保存</translation>
    </message>
    <message>
        <source>3MF, with its size in millimetres (*.3mf)</source>
        <translation>3MF、大きさをミリメートルで記録 (*.3mf)</translation>
    </message>
    <message>
        <source>STL (*.stl)</source>
        <translation>STL (*.stl)</translation>
    </message>
    <message>
        <source>PDF for swell paper (*.pdf)</source>
        <translation>立体コピー用紙のPDF (*.pdf)</translation>
    </message>
    <message>
        <source>BRF for a braille embosser (*.brf)</source>
        <translation>点字プリンターのBRF (*.brf)</translation>
    </message>
    <message>
        <source>G-code for a mill (*.nc)</source>
        <translation>切削機のGコード (*.nc)</translation>
    </message>
    <message>
        <source>SVG for a laser cutter (*.svg)</source>
        <translation>レーザー加工機のSVG (*.svg)</translation>
    </message>
</context>
<context>
    <name>nazori::ui::SpokenActions</name>
    <message>
        <source>%1: on</source>
        <translation>%1：オン</translation>
    </message>
    <message>
        <source>%1: off</source>
        <translation>%1：オフ</translation>
    </message>
</context>
<context>
    <name>nazori::ui::SpokenReadings</name>
    <message>
        <source>There is no reading to speak.</source>
        <translation>読み上げる読みがありません。</translation>
    </message>
    <message>
        <source>Readings are spoken.</source>
        <translation>読みを自動で読み上げます。</translation>
    </message>
    <message>
        <source>Readings are not spoken. V: speak one.</source>
        <translation>読みを自動では読み上げません。V：読み上げる</translation>
    </message>
    <message>
        <source>Voice: %1.</source>
        <translation>声：%1。</translation>
    </message>
    <message>
        <source>No Japanese voice is installed. Install the package espeak-ng.</source>
        <translation>日本語の声がインストールされていません。パッケージ espeak-ng をインストールしてください。</translation>
    </message>
    <message>
        <source>%1 cannot speak: something is missing (%2).</source>
        <translation>%1 で読み上げられません。必要なものがありません（%2）。</translation>
    </message>
    <message>
        <source>Cannot speak: %1.</source>
        <translation>読み上げられません：%1。</translation>
    </message>
    <message>
        <source>Voice for Open JTalk</source>
        <translation>Open JTalk の声</translation>
    </message>
    <message>
        <source>Voices (*.htsvoice)</source>
        <translation>声 (*.htsvoice)</translation>
    </message>
</context>
<context>
    <name>nazori::ui::StageWords</name>
    <message>
        <source>Space: play. Left and Right: step stroke by stroke.</source>
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
        <source>All %n strokes shown. Space: play again. F6: trace.</source>
        <translation>
            <numerusform>全%n画です。スペースキーでもう一度再生、F6 で「なぞる」に進みます。</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>All %n strokes shown. Space: play again. Enter: trace.</source>
        <translation>
            <numerusform>全%n画です。スペースキーでもう一度再生、Enter で「なぞる」に進みます。</numerusform>
        </translation>
    </message>
    <message>
        <source>Speed: %1×.</source>
        <translation>速さ：%1倍。</translation>
    </message>
    <message>
        <source>Press the left button to touch the tablet; the right button turns it.</source>
        <translation>左ボタンで文字板に触れ、右ボタンで回せます。</translation>
    </message>
    <message>
        <source>Touch the tablet with the tip.</source>
        <translation>ペン先で文字板に触れてみましょう。</translation>
    </message>
    <message>
        <source>Hold the left button in a groove and follow it. S: show the strokes.</source>
        <translation>溝の上で左ボタンを押したまま、溝に沿って動かしましょう。S で画を表示します。</translation>
    </message>
    <message>
        <source>Follow a groove. S: show the strokes.</source>
        <translation>溝に沿ってペンを動かしましょう。S で画を表示します。</translation>
    </message>
    <message>
        <source>Hold the left button at number 1 and draw along the groove.</source>
        <translation>番号 1 で左ボタンを押したまま、溝に沿って書きましょう。</translation>
    </message>
    <message>
        <source>Start at number 1 and draw along the groove.</source>
        <translation>番号 1 から、溝に沿って書きましょう。</translation>
    </message>
    <message>
        <source>Follow the groove.</source>
        <translation>溝に沿って書きましょう。</translation>
    </message>
    <message>
        <source>Start each stroke at its number.</source>
        <translation>番号のところから一画ずつ書きましょう。</translation>
    </message>
    <message>
        <source>Let the stylus lead your hand. If you hold back, it gives way.</source>
        <translation>ペンに手を任せましょう。逆らうと力をゆるめます。</translation>
    </message>
    <message>
        <source>%1 Only a force-feedback device can lead your hand; here strokes attract the stylus.</source>
        <translation>%1手を導けるのは力覚デバイスだけです。ここでは画がペン先を引き寄せます。</translation>
    </message>
    <message>
        <source>%1 Written without mistakes so far: %2.</source>
        <translation>%1これまで%2回、間違えずに書けました。</translation>
    </message>
    <message>
        <source>Stroke %1: follow the groove to its end.</source>
        <translation>%1画目：溝の終わりまでなぞりましょう。</translation>
    </message>
    <message>
        <source>Stroke %1 written. Full stop (.): show the next one.</source>
        <translation>%1画目が書けました。ピリオド（.）キーで次の画へ進みます。</translation>
    </message>
    <message>
        <source>Stroke %1 written. Next: stroke %2.</source>
        <translation>%1画目が書けました。次は%2画目です。</translation>
    </message>
    <message>
        <source>Stroke %1 is written, but stroke %2 is not finished: the blue bit is missing.</source>
        <translation>%1画目を書きましたが、%2画目は途中です。青いパーツが残っています。</translation>
    </message>
    <message>
        <source>Stroke %1 is written, but stroke %2 comes first. Write it now.</source>
        <translation>%1画目を書きましたが、先に書くのは%2画目です。次に書いてください。</translation>
    </message>
    <message numerus="yes">
        <source>All %n strokes written. Delete: clear the tablet.</source>
        <translation>
            <numerusform>%n画すべて書けました。Delete で消せます。</numerusform>
        </translation>
    </message>
    <message>
        <source>Stroke %1 is not finished: the blue bit is missing. Draw on from there.</source>
        <translation>%1画目は途中です。青いパーツを続けて書いてください。</translation>
    </message>
    <message>
        <source>Stroke %1 is not finished: draw the blue bit first.</source>
        <translation>%1画目は途中です。先に青いパーツを書いてください。</translation>
    </message>
    <message>
        <source>Stroke %1 comes before stroke %2.</source>
        <translation>%1画目は%2画目より先に書きます。</translation>
    </message>
    <message>
        <source>Start stroke %1 at its other end, at the number.</source>
        <translation>%1画目は反対の端、番号のある所から書き始めます。</translation>
    </message>
    <message>
        <source>Stroke %1 is shown. Start at its number.</source>
        <translation>%1画目を表示しました。番号のところから書いてください。</translation>
    </message>
    <message>
        <source>The stylus has let go. Move on a little by yourself and it leads again.</source>
        <translation>ペンが力をゆるめました。少し自分で進むと、また導きます。</translation>
    </message>
    <message>
        <source>Stroke %1 of %2. Start at its number.</source>
        <translation>%2画のうち%1画目です。番号から書きましょう。</translation>
    </message>
    <message>
        <source>Stroke %1 is selected, but the strokes are hidden. S: show them.</source>
        <translation>%1画目を選びましたが、画は表示されていません。S で表示します。</translation>
    </message>
    <message>
        <source>Snapping off: the stylus moves freely.</source>
        <translation>引き寄せを切りました。ペン先は自由に動きます。</translation>
    </message>
    <message>
        <source>Snapping on: strokes attract the stylus. Pull firmly to leave a stroke.</source>
        <translation>引き寄せを入れました。画がペン先を引き寄せます。強く引くと離れます。</translation>
    </message>
    <message>
        <source>Snapping works only while strokes are visible. S: show them.</source>
        <translation>引き寄せは、画が見えている間だけ働きます。S で画を表示します。</translation>
    </message>
    <message>
        <source>All strokes written, but not all in the right order or direction. Delete: clear and try again.</source>
        <translation>すべて書けましたが、書き順や向きの違う画がありました。Delete で消して、もう一度書けます。</translation>
    </message>
    <message>
        <source>All strokes written, but not all in the right order or direction.</source>
        <translation>すべて書けましたが、書き順や向きの違う画がありました。</translation>
    </message>
    <message>
        <source>No mistakes.</source>
        <translation>間違えずに書けました。</translation>
    </message>
    <message>
        <source>No mistakes. Write it again, now with less help.</source>
        <translation>間違えずに書けました。ガイドを減らします。もう一度書きましょう。</translation>
    </message>
    <message>
        <source>No mistakes, and no help used. F8: write from memory.</source>
        <translation>ガイドなしで、間違えずに書けました。F8 で「見ないで書く」に進みます。</translation>
    </message>
    <message>
        <source>Nothing written yet. H: show the first stroke.</source>
        <translation>まだ何も書いていません。H で最初の画を表示します。</translation>
    </message>
    <message>
        <source>The tablet is full. Delete: clear it.</source>
        <translation>文字板がいっぱいです。Delete で消せます。</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes written. Enter: finish.</source>
        <translation>
            <numerusform>%n画書きました。Enter で判定します。</numerusform>
        </translation>
    </message>
    <message>
        <source>Stroke %1 is shown in blue. Write over it and go on.</source>
        <translation>%1画目を青で表示しました。その上に書いて続けてください。</translation>
    </message>
    <message>
        <source>Stroke %1 is correct. Enter: finish.</source>
        <translation>%1画目は正しく書けました。Enter で判定します。</translation>
    </message>
    <message numerus="yes">
        <source>Stroke %1 is correct. %n to go.</source>
        <translation>
            <numerusform>%1画目は正しく書けました。あと%n画です。</numerusform>
        </translation>
    </message>
    <message>
        <source>Stroke %1 is right. Stroke %2 is still missing.</source>
        <translation>%1画目は正しく書けました。%2画目がまだありません。</translation>
    </message>
    <message>
        <source>Your writing could not be checked: %1. It is still there.</source>
        <translation>判定できませんでした：%1。書いた字はそのままです。</translation>
    </message>
    <message numerus="yes">
        <source>Undone. %n strokes written.</source>
        <translation>
            <numerusform>取り消しました。今は%n画です。</numerusform>
        </translation>
    </message>
    <message>
        <source>All strokes written. Enter: finish.</source>
        <translation>すべての画が書けています。Enter で判定します。</translation>
    </message>
    <message>
        <source>Stroke %1 is shown in blue. H again: show all remaining strokes.</source>
        <translation>%1画目を青で表示しました。もう一度 H を押すと、残りをすべて表示します。</translation>
    </message>
    <message>
        <source>All remaining strokes are shown in blue.</source>
        <translation>残りの画をすべて青で表示しました。</translation>
    </message>
    <message>
        <source>This is how it is written. Delete: clear and try again.</source>
        <translation>こう書きます。Delete で消して、もう一度書けます。</translation>
    </message>
    <message>
        <source>Each stroke is checked as you finish it.</source>
        <translation>一画ごとに判定します。</translation>
    </message>
    <message>
        <source>Your writing is checked at the end: press Enter.</source>
        <translation>最後に判定します。Enter を押してください。</translation>
    </message>
    <message numerus="yes">
        <source>Write the character (%n strokes).</source>
        <translation>
            <numerusform>%n画の字を書きましょう。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 H: hint. Enter: finish.</source>
        <translation>%1H でヒント、Enter で判定します。</translation>
    </message>
    <message>
        <source>%1: %2 H: hint. Enter: finish.</source>
        <translation>%1：%2H でヒント、Enter で判定します。</translation>
    </message>
    <message>
        <source>That stroke isn&apos;t part of this character. Ctrl+Z: undo.</source>
        <translation>この字にはない画です。Ctrl+Z で取り消せます。</translation>
    </message>
    <message>
        <source>%1 H: show where the stroke goes.</source>
        <translation>%1H で書く場所を表示します。</translation>
    </message>
    <message>
        <source>%1 D: show it.</source>
        <translation>%1 D：書き方を見る。</translation>
    </message>
    <message>
        <source>%1 Form: %2 of %3 stars.</source>
        <translation>%1字形は星%3つ中%2つです。</translation>
    </message>
    <message>
        <source>That is %1, another character.</source>
        <translation>それは別の字「%1」です。</translation>
    </message>
    <message>
        <source>That is %1; %2 was asked.</source>
        <translation>それは「%1」です。書くのは「%2」でした。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::StandingBar</name>
    <message>
        <source>due today</source>
        <translation>今日の復習</translation>
    </message>
    <message>
        <source>comes again %1</source>
        <translation>次は%1</translation>
    </message>
    <message>
        <source>%1 likely to be remembered</source>
        <translation>覚えている確率 %1</translation>
    </message>
    <message>
        <source>due with the brush</source>
        <translation>筆で復習</translation>
    </message>
    <message>
        <source>with the brush %1</source>
        <translation>筆は%1</translation>
    </message>
</context>
<context>
    <name>nazori::ui::StartActions</name>
    <message>
        <source>&amp;Write</source>
        <translation>書く(&amp;W)</translation>
    </message>
    <message>
        <source>Save these answers and write the first character</source>
        <translation>答えを保存して最初の文字を書きます</translation>
    </message>
    <message>
        <source>S&amp;kip</source>
        <translation>スキップ(&amp;K)</translation>
    </message>
    <message>
        <source>Leave everything as it is</source>
        <translation>何も変えません</translation>
    </message>
    <message>
        <source>St&amp;udy</source>
        <translation>学習(&amp;U)</translation>
    </message>
</context>
<context>
    <name>nazori::ui::StartButton</name>
    <message>
        <source>%1: %2</source>
        <comment>start, what</comment>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>Enter</source>
        <comment>the key</comment>
        <translation>Enter</translation>
    </message>
</context>
<context>
    <name>nazori::ui::StartPage</name>
    <message>
        <source>Change &amp;what I learn</source>
        <translation>学ぶ内容を変える(&amp;W)</translation>
    </message>
    <message>
        <source>What you want to write, what you know already, and how long a day</source>
        <translation>書きたい文字、もう書ける文字、1日の時間</translation>
    </message>
    <message>
        <source>Type or paste the characters that you want to write.</source>
        <translation>書きたい文字を入力するか、貼り付けてください。</translation>
    </message>
    <message>
        <source>There are no characters to test.</source>
        <translation>テストする文字がありません。</translation>
    </message>
    <message>
        <source>Enter: start. Tab and the arrow keys: other answers.</source>
        <translation>Enter で始めます。ほかの答えは Tab と矢印キーで選べます。</translation>
    </message>
    <message>
        <source>Type or paste the characters that you know.</source>
        <translation>書ける文字を入力するか貼り付けてください。</translation>
    </message>
    <message numerus="yes">
        <source>%Ln characters marked as known. Ctrl+Shift+Z: undo.</source>
        <translation>
            <numerusform>%Ln字を書ける文字にしました。Ctrl+Shift+Z：取り消す</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::StartView</name>
    <message>
        <source>What to learn</source>
        <translation>学ぶ内容</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>What would you like to write?</source>
        <translation>何を書きたいですか。</translation>
    </message>
    <message>
        <source>Hiragana</source>
        <translation>ひらがな</translation>
    </message>
    <message>
        <source>the first step</source>
        <translation>最初の一歩</translation>
    </message>
    <message>
        <source>Katakana</source>
        <translation>カタカナ</translation>
    </message>
    <message>
        <source>for words from abroad</source>
        <translation>外来語に使う文字</translation>
    </message>
    <message>
        <source>Kanji</source>
        <translation>漢字</translation>
    </message>
    <message>
        <source>by grade, JLPT or frequency</source>
        <translation>学年、JLPT、頻度の順</translation>
    </message>
    <message>
        <source>My own list</source>
        <translation>自分のリスト</translation>
    </message>
    <message>
        <source>type or paste any text</source>
        <translation>文章を入力または貼り付け</translation>
    </message>
    <message>
        <source>Which kanji first?</source>
        <translation>どの漢字から始めますか。</translation>
    </message>
    <message>
        <source>By school grade</source>
        <translation>学年順</translation>
    </message>
    <message>
        <source>By JLPT level</source>
        <translation>JLPT のレベル順</translation>
    </message>
    <message>
        <source>By frequency</source>
        <translation>よく使う順</translation>
    </message>
    <message>
        <source>Text with the characters you want to write</source>
        <translation>書きたい文字を含む文章</translation>
    </message>
    <message>
        <source>Type or paste any text. Its kanji become your list.</source>
        <translation>文章を入力するか、貼り付けてください。その中の漢字がリストになります。</translation>
    </message>
    <message>
        <source>What can you write already?</source>
        <translation>もう書ける文字はありますか。</translation>
    </message>
    <message>
        <source>I am new</source>
        <translation>初めて習う</translation>
    </message>
    <message>
        <source>I know kana</source>
        <translation>かなは書ける</translation>
    </message>
    <message>
        <source>I know katakana</source>
        <translation>カタカナは書ける</translation>
    </message>
    <message>
        <source>I know hiragana</source>
        <translation>ひらがなは書ける</translation>
    </message>
    <message>
        <source>I know some kanji</source>
        <translation>漢字も少し書ける</translation>
    </message>
    <message>
        <source>Test me, 2 minutes</source>
        <translation>2分のテストで調べる</translation>
    </message>
    <message>
        <source>How many kanji do you know?</source>
        <translation>どこまでの漢字が書けますか。</translation>
    </message>
    <message>
        <source>up to grade %1</source>
        <translation>小学%1年まで</translation>
    </message>
    <message>
        <source>all school kanji</source>
        <translation>常用漢字すべて</translation>
    </message>
    <message>
        <source>up to old JLPT level %1</source>
        <translation>旧 JLPT %1級まで</translation>
    </message>
    <message>
        <source>Mark these as known</source>
        <translation>書ける文字として印を付ける</translation>
    </message>
    <message>
        <source>Mark nothing</source>
        <translation>印を付けない</translation>
    </message>
    <message>
        <source>The result of the test</source>
        <translation>テストの結果</translation>
    </message>
    <message>
        <source>How long a day?</source>
        <translation>1日にどれくらい学びますか。</translation>
    </message>
    <message>
        <source>Welcome. ようこそ。</source>
        <translation>ようこそ。</translation>
    </message>
    <message>
        <source>What do you want to learn?</source>
        <translation>何を学びますか。</translation>
    </message>
    <message>
        <source>Three questions, then you write. You can change every answer later.</source>
        <translation>3つの質問に答えたら、すぐに書き始めます。答えはあとで変えられます。</translation>
    </message>
    <message>
        <source>Only what you change here is changed.</source>
        <translation>ここで変えたことだけが変わります。</translation>
    </message>
    <message>
        <source>Skip (Esc)</source>
        <translation>スキップ (Esc)</translation>
    </message>
    <message>
        <source>Back (Esc)</source>
        <translation>戻る (Esc)</translation>
    </message>
    <message>
        <source>My list</source>
        <translation>自分のリスト</translation>
    </message>
    <message>
        <source>Start the test</source>
        <translation>テストを始める</translation>
    </message>
    <message>
        <source>Write %1</source>
        <translation>%1 を書く</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存する</translation>
    </message>
    <message>
        <source>Enter: start</source>
        <translation>Enter で始めます</translation>
    </message>
    <message numerus="yes">
        <source>%n characters: %1</source>
        <translation>
            <numerusform>%n字：%1</numerusform>
        </translation>
    </message>
    <message>
        <source>You know every character of this choice already. Choose something else to write.</source>
        <translation>選んだ文字はもうすべて書けます。ほかの文字を選んでください。</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1分</translation>
    </message>
    <message>
        <source>I know these…</source>
        <translation>書ける文字を貼り付ける</translation>
    </message>
    <message>
        <source>Text with the characters you know</source>
        <translation>書ける文字を含む文章</translation>
    </message>
    <message>
        <source>Paste any text or list, from another program for example. Every kanji and kana in it counts as known.</source>
        <translation>文章やリストを貼り付けてください（ほかのアプリのものでもかまいません）。含まれる漢字とかなはすべて書ける文字になります。</translation>
    </message>
    <message numerus="yes">
        <source>%Ln characters will be marked as known: %1</source>
        <translation>
            <numerusform>書ける文字になる%Ln字：%1</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%Ln characters are already studied and stay as they are.</source>
        <translation>
            <numerusform>%Ln字は学習済みなので、そのままです。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::StartWords</name>
    <message>
        <source>You are at the beginning. Nothing is marked as known.</source>
        <translation>これから始めるところです。「書ける」の印は付けません。</translation>
    </message>
    <message>
        <source>You can write about %1 of the %2 hiragana, up to %3.</source>
        <translation>ひらがな%2字のうち約%1字が書けます（%3 まで）。</translation>
    </message>
    <message>
        <source>You can write about %1 of the %2 katakana, up to %3.</source>
        <translation>カタカナ%2字のうち約%1字が書けます（%3 まで）。</translation>
    </message>
    <message>
        <source>You can write about %1 of the %2 characters of your list.</source>
        <translation>リストの%2字のうち約%1字が書けます。</translation>
    </message>
    <message>
        <source>You can write about %1 of the %2 kanji of the old JLPT, up to level %3.</source>
        <translation>旧 JLPT の漢字%2字のうち約%1字が書けます（%3級まで）。</translation>
    </message>
    <message>
        <source>You can write about %1 of the %2 school kanji.</source>
        <translation>常用漢字%2字のうち約%1字が書けます。</translation>
    </message>
    <message>
        <source>You can write about %1 of the %2 school kanji, up to grade %3.</source>
        <translation>常用漢字%2字のうち約%1字が書けます（小学%3年まで）。</translation>
    </message>
    <message>
        <source>You can write about %1 of the %2 school kanji, into secondary school.</source>
        <translation>常用漢字%2字のうち約%1字が書けます（中学以上まで）。</translation>
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
        <source>Force updates per second</source>
        <translation>1秒間に力を更新する回数</translation>
    </message>
    <message>
        <source>Updates that were late or missing since the start</source>
        <translation>起動してから、遅れたか抜けた更新の回数</translation>
    </message>
    <message>
        <source>%1 (no force)</source>
        <translation>%1（力覚なし）</translation>
    </message>
    <message>
        <source>depth %1 mm</source>
        <translation>深さ %1 mm</translation>
    </message>
    <message>
        <source>%1 times per second</source>
        <translation>毎秒%1回</translation>
    </message>
    <message>
        <source>starting</source>
        <translation>開始中</translation>
    </message>
    <message>
        <source>Average time per update, longest delay of an update since the start, and longest delay of the display in the last second</source>
        <translation>更新1回の平均時間、起動してからの最大の遅れ、直前の1秒間の表示の最大の遅れ</translation>
    </message>
    <message>
        <source>update %1 µs, delay %2 ms</source>
        <translation>更新 %1 µs・遅れ %2 ms</translation>
    </message>
    <message>
        <source>%1, display %2 ms</source>
        <translation>%1・表示 %2 ms</translation>
    </message>
    <message>
        <source>%1 missed</source>
        <translation>抜け%1回</translation>
    </message>
    <message>
        <source>● %1, %2 s</source>
        <translation>● %1、%2秒</translation>
    </message>
    <message>
        <source>%1, %2 lost</source>
        <translation>%1、抜け %2</translation>
    </message>
    <message>
        <source>Recording pen motion to %1</source>
        <translation>ペンの動きを %1 に記録しています</translation>
    </message>
</context>
<context>
    <name>nazori::ui::StrengthModel</name>
    <message>
        <source>%1, %2</source>
        <translation>%1、%2</translation>
    </message>
    <message>
        <source>%1, %2, %3 likely to be remembered</source>
        <translation>%1、%2、思い出せる確率%3</translation>
    </message>
</context>
<context>
    <name>nazori::ui::StrictnessSlider</name>
    <message>
        <source>Str&amp;ictness</source>
        <translation>判定の厳しさ(&amp;I)</translation>
    </message>
    <message>
        <source>Strictness</source>
        <translation>判定の厳しさ</translation>
    </message>
    <message>
        <source>How strictly your writing is checked (Ctrl+[ and Ctrl+])</source>
        <translation>判定の厳しさ（Ctrl+[ と Ctrl+]）</translation>
    </message>
    <message>
        <source>lenient</source>
        <translation>やさしい</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>ふつう</translation>
    </message>
    <message>
        <source>strict</source>
        <translation>きびしい</translation>
    </message>
    <message>
        <source>fairly lenient</source>
        <translation>少しやさしい</translation>
    </message>
    <message>
        <source>fairly strict</source>
        <translation>少しきびしい</translation>
    </message>
</context>
<context>
    <name>nazori::ui::StrokeCounter</name>
    <message>
        <source>no strokes</source>
        <translation>画なし</translation>
    </message>
    <message numerus="yes">
        <source>all %n strokes</source>
        <translation>
            <numerusform>全%n画</numerusform>
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
        <source>horizontal stroke</source>
        <translation>横画</translation>
    </message>
    <message>
        <source>vertical stroke</source>
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
        <translation>右上払い</translation>
    </message>
    <message>
        <source>horizontal stroke with a hook</source>
        <translation>横画はね</translation>
    </message>
    <message>
        <source>vertical stroke with a hook</source>
        <translation>縦画はね</translation>
    </message>
    <message>
        <source>horizontal stroke that turns down</source>
        <translation>横折れ</translation>
    </message>
    <message>
        <source>horizontal stroke that turns down, with a hook</source>
        <translation>横折れはね</translation>
    </message>
    <message>
        <source>vertical stroke that turns right</source>
        <translation>縦折れ</translation>
    </message>
    <message>
        <source>vertical stroke that bends right, with a hook</source>
        <translation>縦曲がりはね</translation>
    </message>
    <message>
        <source>vertical stroke that rises at the end</source>
        <translation>縦画から右上払い</translation>
    </message>
    <message>
        <source>horizontal stroke that turns into a left sweep</source>
        <translation>横折れ左払い</translation>
    </message>
    <message>
        <source>curved stroke with a hook</source>
        <translation>曲がりはね</translation>
    </message>
    <message>
        <source>slanting stroke with a hook</source>
        <translation>そりはね</translation>
    </message>
    <message>
        <source>flat curve with a hook</source>
        <translation>平そりはね</translation>
    </message>
    <message>
        <source>horizontal stroke that bends, with a hook</source>
        <translation>横曲がりはね</translation>
    </message>
    <message>
        <source>horizontal stroke that turns down, then rises</source>
        <translation>横折れ右上払い</translation>
    </message>
    <message>
        <source>sweep to the left that turns right</source>
        <translation>左払い折れ</translation>
    </message>
    <message>
        <source>sweep to the left that turns into a dot</source>
        <translation>左払い点</translation>
    </message>
    <message>
        <source>stroke with three turns</source>
        <translation>三つ折れ</translation>
    </message>
    <message>
        <source>stroke with several turns and a hook</source>
        <translation>折れ重なりはね</translation>
    </message>
    <message>
        <source>stroke with two turns and a sweep to the left</source>
        <translation>二つ折れ左払い</translation>
    </message>
    <message>
        <source>stroke that turns and curves, with a hook</source>
        <translation>横折れ曲がりはね</translation>
    </message>
    <message>
        <source>It ends with a stop.</source>
        <translation>終わりは、とめます。</translation>
    </message>
    <message>
        <source>It ends with a hook.</source>
        <translation>終わりは、はねます。</translation>
    </message>
    <message>
        <source>It ends with a sweep: lift the pen while it is still moving.</source>
        <translation>終わりは、はらいます。</translation>
    </message>
    <message>
        <source>It may end with a stop or a sweep.</source>
        <translation>終わりは、とめても、はらってもかまいません。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::StudyCharts</name>
    <message>
        <source>Day</source>
        <translation>日</translation>
    </message>
    <message>
        <source>Week starting</source>
        <translation>週（始まり）</translation>
    </message>
    <message>
        <source>Month starting</source>
        <translation>月（始まり）</translation>
    </message>
    <message>
        <source>%1%</source>
        <translation>%1%</translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1分</translation>
    </message>
    <message>
        <source>%1 h %2 min</source>
        <translation>%1時間%2分</translation>
    </message>
    <message>
        <source>not studied</source>
        <translation>未学習</translation>
    </message>
    <message>
        <source>learning</source>
        <translation>学習中</translation>
    </message>
    <message>
        <source>recently learned</source>
        <translation>覚えたて</translation>
    </message>
    <message>
        <source>well known</source>
        <translation>定着</translation>
    </message>
    <message>
        <source>difficult</source>
        <translation>苦手</translation>
    </message>
    <message>
        <source>suspended</source>
        <translation>休止中</translation>
    </message>
    <message>
        <source>wrong order</source>
        <translation>書き順の違い</translation>
    </message>
    <message>
        <source>drawn backwards</source>
        <translation>逆向き</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>書き忘れ</translation>
    </message>
    <message>
        <source>extra stroke</source>
        <translation>余分な画</translation>
    </message>
    <message>
        <source>joined to another stroke</source>
        <translation>ほかの画とつながり</translation>
    </message>
    <message>
        <source>split into pieces</source>
        <translation>途切れた画</translation>
    </message>
    <message>
        <source>wrong shape or position</source>
        <translation>形や位置の違い</translation>
    </message>
    <message>
        <source>stroke of another character</source>
        <translation>ほかの文字の画</translation>
    </message>
    <message>
        <source>wrong ending</source>
        <translation>とめ・はね・はらいの違い</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <comment>a fault, how often</comment>
        <translation>%1（%2）</translation>
    </message>
    <message>
        <source>Upcoming reviews</source>
        <translation>これからの復習</translation>
    </message>
    <message>
        <source>Write a character from memory once, and its next review will appear here.</source>
        <translation>見ないで一度書くと、次の復習日がここに並びます。</translation>
    </message>
    <message>
        <source>Reviews</source>
        <translation>復習</translation>
    </message>
    <message>
        <source>Next 30 days: %1. Today: %2. Busiest day: %3 (%4).</source>
        <translation>今後30日間：%1件、今日：%2件。最も多い日：%3（%4件）。</translation>
    </message>
    <message>
        <source>Reviews and minutes</source>
        <translation>復習と時間</translation>
    </message>
    <message>
        <source>Nothing written in this period. What you write appears here, day by day.</source>
        <translation>この期間には何も書いていません。書いたものが日ごとに並びます。</translation>
    </message>
    <message>
        <source>Practice</source>
        <translation>練習</translation>
    </message>
    <message>
        <source>New</source>
        <translation>新しい字</translation>
    </message>
    <message>
        <source>Minutes</source>
        <translation>分</translation>
    </message>
    <message>
        <source>Reviews: %1 in %2. Study days: %3, with about %4 reviews in %5 min each.</source>
        <translation>復習：%1回、%2。学習した日：%3日（1日に約%4回、%5分）。</translation>
    </message>
    <message>
        <source>Recall: actual and predicted</source>
        <translation>思い出せた割合と予測</translation>
    </message>
    <message>
        <source>Starts when a character comes back after a day or more. Come back tomorrow.</source>
        <translation>1日以上たって文字がまた出ると集計します。明日また来てください。</translation>
    </message>
    <message>
        <source>Recalled</source>
        <translation>思い出せた割合</translation>
    </message>
    <message>
        <source>Predicted</source>
        <translation>予測</translation>
    </message>
    <message>
        <source>Reviews after a day or more: %1. Recalled %2, predicted %3.</source>
        <translation>1日以上たってからの復習：%1回。思い出せた割合 %2、予測 %3。</translation>
    </message>
    <message>
        <source>Speed and smoothness of the pen</source>
        <translation>ペンの速さとなめらかさ</translation>
    </message>
    <message>
        <source>Shown once you have written on the tablet with a mouse, pen or stylus.</source>
        <translation>文字板に書くと表示されます（マウス、ペン、力覚デバイス）。</translation>
    </message>
    <message>
        <source>Times written</source>
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
        <source>Speed in character widths per second: %1 at first, %2 now. Smoothness: %3 at first, %4 now (closer to 0 is smoother).</source>
        <translation>速さ（毎秒の字幅）：最初 %1、今 %2。なめらかさ：最初 %3、今 %4（0 に近いほどなめらか）。</translation>
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
        <source>Times wrong</source>
        <translation>間違えた回数</translation>
    </message>
    <message>
        <source>Mistakes</source>
        <translation>間違いの内容</translation>
    </message>
    <message>
        <source>Up&amp;coming reviews</source>
        <translation>これからの復習(&amp;C)</translation>
    </message>
    <message>
        <source>Go to the upcoming reviews</source>
        <translation>これからの復習へ移ります</translation>
    </message>
    <message>
        <source>&amp;Recall: actual and predicted</source>
        <translation>思い出せた割合と予測(&amp;R)</translation>
    </message>
    <message>
        <source>Go to actual and predicted recall</source>
        <translation>思い出せた割合と予測へ移ります</translation>
    </message>
    <message>
        <source>Reviews and &amp;minutes</source>
        <translation>復習と時間(&amp;M)</translation>
    </message>
    <message>
        <source>Go to reviews and minutes</source>
        <translation>復習と時間へ移ります</translation>
    </message>
    <message>
        <source>&amp;Speed and smoothness</source>
        <translation>速さとなめらかさ(&amp;S)</translation>
    </message>
    <message>
        <source>Go to speed and smoothness of the pen</source>
        <translation>ペンの速さとなめらかさへ移ります</translation>
    </message>
</context>
<context>
    <name>nazori::ui::StudySettingsDialog</name>
    <message>
        <source>Your lists and tags cannot be read: %1</source>
        <translation>自分のリストとタグを読めません：%1</translation>
    </message>
    <message>
        <source>Settings saved.</source>
        <translation>設定を保存しました。</translation>
    </message>
    <message>
        <source>Tags</source>
        <translation>タグ</translation>
    </message>
    <message>
        <source>Tags for %1, separated by commas:</source>
        <translation>%1 のタグ（コンマで区切ります）：</translation>
    </message>
    <message>
        <source>Study settings</source>
        <translation>学習の設定</translation>
    </message>
    <message>
        <source>Daily goal</source>
        <translation>1日の目標</translation>
    </message>
    <message>
        <source>Desired retention</source>
        <translation>目標の定着率</translation>
    </message>
    <message>
        <source>&amp;New characters per day (maximum)</source>
        <translation>1日の新しい字の上限(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Reviews per day (maximum)</source>
        <translation>1日の復習の上限(&amp;R)</translation>
    </message>
    <message>
        <source>A study &amp;day starts at (hour)</source>
        <translation>学習の1日が始まる時刻（時）(&amp;D)</translation>
    </message>
    <message>
        <source>Time zone</source>
        <translation>タイムゾーン</translation>
    </message>
    <message>
        <source>same as the computer</source>
        <translation>コンピューターと同じ</translation>
    </message>
    <message>
        <source>Time &amp;zone</source>
        <translation>タイムゾーン(&amp;Z)</translation>
    </message>
    <message>
        <source>Lists</source>
        <translation>リスト</translation>
    </message>
    <message>
        <source>Order of new characters</source>
        <translation>新しい字の順番</translation>
    </message>
    <message>
        <source>by school grade</source>
        <translation>学年順</translation>
    </message>
    <message>
        <source>most common first</source>
        <translation>よく使う順</translation>
    </message>
    <message>
        <source>fewest strokes first</source>
        <translation>画数の少ない順</translation>
    </message>
    <message>
        <source>simple parts first</source>
        <translation>パーツになる字から先に</translation>
    </message>
    <message>
        <source>in list order</source>
        <translation>リストの順</translation>
    </message>
    <message>
        <source>&amp;Order of new characters</source>
        <translation>新しい字の順番(&amp;O)</translation>
    </message>
    <message>
        <source>Lists to learn from</source>
        <translation>学習するリスト</translation>
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
        <translation>すべて延期…</translation>
    </message>
    <message>
        <source>Postpone</source>
        <translation>延期</translation>
    </message>
    <message>
        <source>Days</source>
        <translation>日数</translation>
    </message>
    <message numerus="yes">
        <source>%n characters postponed.</source>
        <translation>
            <numerusform>%n字を延期しました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Suspend all</source>
        <translation>すべて休止</translation>
    </message>
    <message numerus="yes">
        <source>%n characters suspended.</source>
        <translation>
            <numerusform>%n字を休止しました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Resume all</source>
        <translation>すべて再開</translation>
    </message>
    <message numerus="yes">
        <source>%n characters resumed.</source>
        <translation>
            <numerusform>%n字を再開しました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Start all over</source>
        <translation>すべて最初から</translation>
    </message>
    <message numerus="yes">
        <source>%n characters started over as new.</source>
        <translation>
            <numerusform>%n字を新しい字に戻しました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Mistakes on a stroke before a &amp;hint is offered</source>
        <translation>ヒントを勧めるまでに間違える回数（1画あたり）(&amp;H)</translation>
    </message>
    <message>
        <source>Mistakes before the stroke is &amp;shown</source>
        <translation>画を表示するまでに間違える回数(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Lapses before a character must be relearned</source>
        <translation>覚え直しになるまでに忘れる回数(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Vary review intervals a little</source>
        <translation>復習の間隔を少しずらす(&amp;V)</translation>
    </message>
    <message>
        <source>Pref&amp;er days with fewer reviews</source>
        <translation>復習の少ない日を選ぶ(&amp;E)</translation>
    </message>
    <message>
        <source>Custom FSRS parameters…</source>
        <translation>FSRS パラメーターを指定…</translation>
    </message>
    <message>
        <source>Default parameters</source>
        <translation>標準のパラメーター</translation>
    </message>
    <message>
        <source>Start Nazori on &amp;Home</source>
        <translation>起動したらホームを開く(&amp;H)</translation>
    </message>
    <message>
        <source>Sometimes ask with a &amp;word that leaves out the character</source>
        <translation>ときどき、その文字を抜いた言葉で出題する(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Left-handed: panels, next button, brush and light change sides</source>
        <translation>左利き：パネル、次へ進むボタン、筆、光の左右を入れ替える(&amp;L)</translation>
    </message>
    <message>
        <source>One-handed keys</source>
        <translation>片手用のキー</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>left hand: 1 2 3 4, E next, W hint, X undo</source>
        <translation>左手：1 2 3 4、E で次へ、W でヒント、X で取り消し</translation>
    </message>
    <message>
        <source>right hand: 7 8 9 0, K next, U hint, Backspace undo</source>
        <translation>右手：7 8 9 0、K で次へ、U でヒント、Backspace で取り消し</translation>
    </message>
    <message>
        <source>One-handed &amp;keys</source>
        <translation>片手用のキー(&amp;K)</translation>
    </message>
    <message numerus="yes">
        <source>With %1 new characters a day: about %2 reviews and %n minutes a day, and about %3 characters known after a year. Higher retention means more reviews.</source>
        <translation>
            <numerusform>1日に新しい字が%1字なら、復習は1日に約%2件、約%n分です。1年後には約%3字を覚えています。定着率を高くすると復習が増えます。</numerusform>
        </translation>
    </message>
    <message>
        <source>No list is selected, so no new characters will come up.</source>
        <translation>リストが選ばれていません。新しい字は出ません。</translation>
    </message>
    <message numerus="yes">
        <source>%Ln characters selected, %1 of them already studied.</source>
        <translation>
            <numerusform>%Ln字が選ばれ、そのうち%1字は学習済みです。</numerusform>
        </translation>
    </message>
    <message>
        <source>Only your own lists can be removed.</source>
        <translation>削除できるのは自分のリストだけです。</translation>
    </message>
    <message>
        <source>Remove the list</source>
        <translation>リストの削除</translation>
    </message>
    <message>
        <source>Remove “%1”? Your progress with its characters is kept.</source>
        <translation>「%1」を削除しますか。文字の学習データは残ります。</translation>
    </message>
    <message>
        <source>This list is empty.</source>
        <translation>このリストは空です。</translation>
    </message>
    <message>
        <source>Ctrl+Shift+Z: undo.</source>
        <translation>Ctrl+Shift+Z で取り消せます。</translation>
    </message>
    <message>
        <source>FSRS-6 with default parameters.</source>
        <translation>FSRS-6、標準のパラメーター。</translation>
    </message>
    <message>
        <source>FSRS-6 with custom parameters (the first is %1).</source>
        <translation>FSRS-6、指定したパラメーター（最初の値は %1）。</translation>
    </message>
    <message>
        <source>FSRS parameters</source>
        <translation>FSRS パラメーター</translation>
    </message>
    <message>
        <source>21, 19 or 17 numbers, as Anki shows them:</source>
        <translation>Anki に表示されるとおりの 21、19 または 17 個の数値：</translation>
    </message>
    <message>
        <source>These parameters cannot be used: %1.</source>
        <translation>このパラメーターは使えません：%1。</translation>
    </message>
    <message>
        <source>Review</source>
        <translation>復習</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>ウィンドウ</translation>
    </message>
    <message>
        <source>Add to list</source>
        <translation>リストに加える</translation>
    </message>
    <message>
        <source>List for %1. Choose one, or type a new name; ✓: it is in the list already.</source>
        <translation>%1を入れるリストを選ぶか、新しい名前を入力してください。✓：すでに入っています。</translation>
    </message>
    <message>
        <source>Took %1 out of the list “%2”.</source>
        <translation>%1をリスト「%2」から外しました。</translation>
    </message>
    <message>
        <source>Added %1 to the list “%2”.</source>
        <translation>%1をリスト「%2」に加えました。</translation>
    </message>
    <message>
        <source>I know these…</source>
        <translation>知っている文字を登録…</translation>
    </message>
    <message numerus="yes">
        <source>%Ln characters marked as known.</source>
        <translation>
            <numerusform>%Ln字を知っている文字にしました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Characters with the &amp;brush per day (maximum)</source>
        <translation>1日に筆で書く文字の上限(&amp;B)</translation>
    </message>
    <message>
        <source>off</source>
        <translation>オフ</translation>
    </message>
    <message>
        <source>Well known characters are also written with the brush, on the page Brush. These reviews are scheduled apart from those from memory.</source>
        <translation>定着した文字を「筆」のページで筆でも書きます。予定は、見ないで書く復習とは別に決まります。</translation>
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
        <translation>ガイド付きで書く</translation>
    </message>
    <message>
        <source>Memory</source>
        <translation>見ないで書く</translation>
    </message>
    <message numerus="yes">
        <source>in %n minutes</source>
        <translation>
            <numerusform>%n分後</numerusform>
        </translation>
    </message>
    <message>
        <source>tomorrow</source>
        <translation>明日</translation>
    </message>
    <message numerus="yes">
        <source>in %n days</source>
        <translation>
            <numerusform>%n日後</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>in %n months</source>
        <translation>
            <numerusform>%nか月後</numerusform>
        </translation>
    </message>
    <message>
        <source>in %1 years</source>
        <translation>%1年後</translation>
    </message>
    <message>
        <source>less than a minute</source>
        <translation>1分未満</translation>
    </message>
    <message numerus="yes">
        <source>about %n minutes</source>
        <translation>
            <numerusform>約%n分</numerusform>
        </translation>
    </message>
    <message>
        <source>%1 min</source>
        <translation>%1分</translation>
    </message>
    <message>
        <source>%1 d</source>
        <translation>%1日</translation>
    </message>
    <message>
        <source>%1 mo</source>
        <translation>%1か月</translation>
    </message>
    <message>
        <source>%1 y</source>
        <translation>%1年</translation>
    </message>
    <message>
        <source>not written correctly</source>
        <translation>正しく書けなかった</translation>
    </message>
    <message>
        <source>strokes were shown</source>
        <translation>画を見せてもらった</translation>
    </message>
    <message>
        <source>several hints</source>
        <translation>ヒントを何度も使った</translation>
    </message>
    <message>
        <source>written with help</source>
        <translation>ガイドを使った</translation>
    </message>
    <message>
        <source>with a hint</source>
        <translation>ヒントを使った</translation>
    </message>
    <message>
        <source>a stroke was wrong at first</source>
        <translation>はじめに画を間違えた</translation>
    </message>
    <message>
        <source>correct, with a mistake</source>
        <translation>正解だが間違いがある</translation>
    </message>
    <message>
        <source>correct, but the form is poor</source>
        <translation>正解だが形が整っていない</translation>
    </message>
    <message>
        <source>correct, but slower than usual</source>
        <translation>正解だがいつもより遅い</translation>
    </message>
    <message>
        <source>no mistakes, and quick</source>
        <translation>間違いがなく速い</translation>
    </message>
    <message>
        <source>correct</source>
        <translation>正解</translation>
    </message>
    <message>
        <source>the long vowel mark</source>
        <translation>長音符</translation>
    </message>
    <message>
        <source>small %1</source>
        <translation>小さい %1</translation>
    </message>
    <message>
        <source>%1 (typed %2)</source>
        <translation>%1（入力は %2）</translation>
    </message>
    <message>
        <source>hiragana: %1</source>
        <translation>ひらがな：%1</translation>
    </message>
    <message>
        <source>katakana: %1</source>
        <translation>カタカナ：%1</translation>
    </message>
    <message>
        <source>Brush</source>
        <translation>筆</translation>
    </message>
</context>
<context>
    <name>nazori::ui::TablePicker</name>
    <message>
        <source>Parts by number of strokes</source>
        <translation>画数順のパーツ</translation>
    </message>
    <message>
        <source>Radicals by number of strokes</source>
        <translation>画数順の部首</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes</source>
        <translation>
            <numerusform>%n画</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1, %n strokes</source>
        <translation>
            <numerusform>%1、%n画</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::ToolBar</name>
    <message>
        <source>Tablet style (Ctrl+1, 2, 3)</source>
        <translation>文字板の見た目（Ctrl+1、2、3）</translation>
    </message>
    <message>
        <source>Tablet style: %1</source>
        <translation>文字板の見た目：%1</translation>
    </message>
    <message>
        <source>Toolbar</source>
        <translation>ツールバー</translation>
    </message>
</context>
<context>
    <name>nazori::ui::TraceDialog</name>
    <message>
        <source>Character</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>Strokes of a font</source>
        <translation>フォントから画を見つける</translation>
    </message>
    <message>
        <source>Strokes of a picture</source>
        <translation>画像から画を見つける</translation>
    </message>
    <message>
        <source>Picture</source>
        <translation>画像</translation>
    </message>
    <message>
        <source>&amp;Character</source>
        <translation>文字(&amp;C)</translation>
    </message>
    <message>
        <source>Font</source>
        <translation>フォント</translation>
    </message>
    <message>
        <source>&amp;Font</source>
        <translation>フォント(&amp;F)</translation>
    </message>
    <message>
        <source>If you type the character, its strokes get their order, direction and ending. Leave it empty for a sign of your own.</source>
        <translation>文字を入力すると、書き順、向き、終わり方が付きます。自分の記号のときは空のままにします。</translation>
    </message>
    <message>
        <source>&amp;Find strokes</source>
        <translation>画を見つける(&amp;F)</translation>
    </message>
    <message>
        <source>Type a character.</source>
        <translation>文字を入力してください。</translation>
    </message>
    <message>
        <source>No installed font has this character.</source>
        <translation>この文字のあるフォントがありません。</translation>
    </message>
    <message numerus="yes">
        <source>%n fonts have this character.</source>
        <translation>
            <numerusform>この文字のあるフォント：%n種類。</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>nazori::ui::TroubleWords</name>
    <message>
        <source>%1 is often forgotten.</source>
        <translation>「%1」をよく忘れます。</translation>
    </message>
    <message>
        <source>Stroke %1 of %2 is often out of order.</source>
        <translation>「%2」の%1画目の順番をよく間違えます。</translation>
    </message>
    <message>
        <source>Stroke %1 of %2 is often written backwards.</source>
        <translation>「%2」の%1画目がよく逆向きになります。</translation>
    </message>
    <message>
        <source>Stroke %1 of %2 is often left out.</source>
        <translation>「%2」の%1画目がよく抜けます。</translation>
    </message>
    <message>
        <source>Stroke %1 of %2 is often joined to another one.</source>
        <translation>「%2」の%1画目がよく他の画とつながります。</translation>
    </message>
    <message>
        <source>Stroke %1 of %2 is often written in pieces.</source>
        <translation>「%2」の%1画目がよく途中で切れます。</translation>
    </message>
    <message>
        <source>%1 often gets one stroke too many.</source>
        <translation>「%1」の画がよく1画多くなります。</translation>
    </message>
    <message>
        <source>%1 is often mistaken for another character.</source>
        <translation>「%1」をよく別の文字と間違えます。</translation>
    </message>
    <message>
        <source>Stroke %1 of %2 often has the wrong shape or position.</source>
        <translation>「%2」の%1画目の形や位置をよく間違えます。</translation>
    </message>
    <message>
        <source>Stroke %1 was out of order in %2 of %3 writings.</source>
        <translation>%1画目：%3回中%2回、順番が違いました。</translation>
    </message>
    <message>
        <source>Stroke %1 was written backwards in %2 of %3 writings.</source>
        <translation>%1画目：%3回中%2回、逆向きでした。</translation>
    </message>
    <message>
        <source>Stroke %1 was left out in %2 of %3 writings.</source>
        <translation>%1画目：%3回中%2回、抜けました。</translation>
    </message>
    <message>
        <source>Stroke %1 was joined to another one in %2 of %3 writings.</source>
        <translation>%1画目：%3回中%2回、他の画とつながりました。</translation>
    </message>
    <message>
        <source>Stroke %1 was written in pieces in %2 of %3 writings.</source>
        <translation>%1画目：%3回中%2回、途中で切れました。</translation>
    </message>
    <message>
        <source>Stroke %1 was one too many in %2 of %3 writings.</source>
        <translation>%1画目：%3回中%2回、余分でした。</translation>
    </message>
    <message>
        <source>Stroke %1 belonged to another character in %2 of %3 writings.</source>
        <translation>%1画目：%3回中%2回、別の文字の画でした。</translation>
    </message>
    <message>
        <source>Stroke %1 ended wrongly in %2 of %3 writings.</source>
        <translation>%1画目：%3回中%2回、終わり方が違いました。</translation>
    </message>
    <message>
        <source>Stroke %1 had the wrong shape or position in %2 of %3 writings.</source>
        <translation>%1画目：%3回中%2回、形や位置が違いました。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::UnsavedBox</name>
    <message>
        <source>Save…</source>
        <translation>保存…</translation>
    </message>
    <message>
        <source>Do not save</source>
        <translation>保存しない</translation>
    </message>
    <message>
        <source>Go back</source>
        <translation>戻る</translation>
    </message>
</context>
<context>
    <name>nazori::ui::WatchView</name>
    <message>
        <source>%1 of %2 · %3×</source>
        <translation>%1／%2画 · %3倍</translation>
    </message>
    <message>
        <source>no strokes</source>
        <translation>画なし</translation>
    </message>
</context>
<context>
    <name>nazori::ui::WordBoxes</name>
    <message>
        <source>The characters of the word</source>
        <translation>言葉の文字</translation>
    </message>
    <message>
        <source>Character %1: right</source>
        <translation>%1文字目：正解</translation>
    </message>
    <message>
        <source>Character %1: not right</source>
        <translation>%1文字目：もう少し</translation>
    </message>
    <message>
        <source>Character %1: being written</source>
        <translation>%1文字目：書いています</translation>
    </message>
    <message>
        <source>Character %1: empty</source>
        <translation>%1文字目：まだ書いていません</translation>
    </message>
</context>
<context>
    <name>nazori::ui::WorksheetDialog</name>
    <message>
        <source>Preview</source>
        <translation>プレビュー</translation>
    </message>
    <message>
        <source>Previous page</source>
        <translation>前のページ</translation>
    </message>
    <message>
        <source>Next page</source>
        <translation>次のページ</translation>
    </message>
    <message>
        <source>Print a worksheet</source>
        <translation>プリントを作る</translation>
    </message>
    <message>
        <source>Show the previous page (%1)</source>
        <translation>前のページを表示します（%1）</translation>
    </message>
    <message>
        <source>Show the next page (%1)</source>
        <translation>次のページを表示します（%1）</translation>
    </message>
    <message>
        <source>&amp;Save as PDF…</source>
        <translation>PDF で保存(&amp;S)…</translation>
    </message>
    <message numerus="yes">
        <source>Saved %n pages as %1.</source>
        <translation>
            <numerusform>%nページを %1 に保存しました。</numerusform>
        </translation>
    </message>
    <message>
        <source>%1: %2. Nothing was saved.</source>
        <translation>%1：%2。何も保存していません。</translation>
    </message>
    <message>
        <source>Page %1 of %2</source>
        <translation>%1/%2ページ</translation>
    </message>
    <message numerus="yes">
        <source>%n pages</source>
        <translation>
            <numerusform>%nページ</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n characters</source>
        <translation>
            <numerusform>%n字</numerusform>
        </translation>
    </message>
    <message>
        <source>Not in the database: %1</source>
        <translation>データベースにない文字：%1</translation>
    </message>
    <message>
        <source>There is no preview: %1.</source>
        <translation>プレビューできません：%1。</translation>
    </message>
    <message>
        <source>The rows do not fit on a page. Choose fewer rows or smaller cells.</source>
        <translation>行が1ページに収まりません。行を減らすか、ますを小さくしてください。</translation>
    </message>
    <message>
        <source>None of these characters has a word to ask. Choose other characters.</source>
        <translation>出題できる言葉のある文字がありません。別の文字を選んでください。</translation>
    </message>
    <message>
        <source>No reviews are due now. Choose other characters.</source>
        <translation>今は復習する文字がありません。別の文字を選んでください。</translation>
    </message>
    <message>
        <source>There are no difficult characters. Choose other characters.</source>
        <translation>苦手な文字はありません。別の文字を選んでください。</translation>
    </message>
    <message>
        <source>Type or paste a text with characters to write.</source>
        <translation>書く文字の入った文章を入力するか、貼り付けてください。</translation>
    </message>
    <message>
        <source>This list is empty. Choose other characters.</source>
        <translation>このリストは空です。別の文字を選んでください。</translation>
    </message>
    <message>
        <source>Save as PDF</source>
        <translation>PDF で保存</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>worksheet</source>
        <translation>プリント</translation>
    </message>
    <message>
        <source>Writing %1…</source>
        <translation>%1 を書き出し中…</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>止める</translation>
    </message>
    <message>
        <source>Stopped. Nothing was saved.</source>
        <translation>止めました。何も保存していません。</translation>
    </message>
</context>
<context>
    <name>nazori::ui::WorksheetOptions</name>
    <message>
        <source>&amp;Characters</source>
        <translation>文字(&amp;C)</translation>
    </message>
    <message>
        <source>The character shown: %1</source>
        <translation>表示中の文字：%1</translation>
    </message>
    <message>
        <source>A list</source>
        <translation>リスト</translation>
    </message>
    <message>
        <source>Today&apos;s reviews</source>
        <translation>今日の復習</translation>
    </message>
    <message>
        <source>Difficult characters</source>
        <translation>苦手な文字</translation>
    </message>
    <message>
        <source>From a text</source>
        <translation>文章から</translation>
    </message>
    <message>
        <source>List</source>
        <translation>リスト</translation>
    </message>
    <message>
        <source>&amp;List</source>
        <translation>リスト(&amp;L)</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>文章</translation>
    </message>
    <message>
        <source>Te&amp;xt</source>
        <translation>文章(&amp;X)</translation>
    </message>
    <message>
        <source>Paste a text here</source>
        <translation>ここに文章を貼り付けます</translation>
    </message>
    <message>
        <source>&amp;Kind</source>
        <translation>種類(&amp;K)</translation>
    </message>
    <message>
        <source>Practice sheet</source>
        <translation>練習プリント</translation>
    </message>
    <message>
        <source>Quiz</source>
        <translation>小テスト</translation>
    </message>
    <message>
        <source>Flash cards</source>
        <translation>カード</translation>
    </message>
    <message>
        <source>Manuscript paper</source>
        <translation>原稿用紙</translation>
    </message>
    <message>
        <source>Brush sheet</source>
        <translation>毛筆の練習用紙</translation>
    </message>
    <message>
        <source>&amp;Paper</source>
        <translation>用紙(&amp;P)</translation>
    </message>
    <message>
        <source>A4</source>
        <translation>A4</translation>
    </message>
    <message>
        <source>B5</source>
        <translation>B5</translation>
    </message>
    <message>
        <source>Letter</source>
        <translation>レター</translation>
    </message>
    <message>
        <source>Hanshi</source>
        <translation>半紙</translation>
    </message>
    <message>
        <source>Cell si&amp;ze</source>
        <translation>ますの大きさ(&amp;Z)</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>&amp;Guide lines</source>
        <translation>補助線(&amp;G)</translation>
    </message>
    <message>
        <source>None</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>Cross 十</source>
        <translation>十字</translation>
    </message>
    <message>
        <source>Four fields 田</source>
        <translation>田の字</translation>
    </message>
    <message>
        <source>Eight parts 米</source>
        <translation>米の字</translation>
    </message>
    <message>
        <source>&amp;One character a page</source>
        <translation>1ページに1字(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Rows per character</source>
        <translation>1字あたりの行数(&amp;R)</translation>
    </message>
    <message>
        <source>Cells to &amp;trace, fading</source>
        <translation>なぞるます（しだいに薄く）(&amp;T)</translation>
    </message>
    <message>
        <source>C&amp;haracters per sheet</source>
        <translation>1枚の文字数(&amp;H)</translation>
    </message>
    <message>
        <source>Sheets o&amp;f the same characters</source>
        <translation>同じ字の枚数(&amp;F)</translation>
    </message>
    <message>
        <source>Sheets to &amp;trace, fading</source>
        <translation>なぞる枚数（しだいに薄く）(&amp;T)</translation>
    </message>
    <message>
        <source>Stroke &amp;order, step by step</source>
        <translation>書き順を1画ずつ(&amp;O)</translation>
    </message>
    <message>
        <source>Stroke &amp;numbers</source>
        <translation>書き順の番号(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Arrows on the strokes</source>
        <translation>画の矢印(&amp;A)</translation>
    </message>
    <message>
        <source>Readings, &amp;meanings and words</source>
        <translation>読み、意味、言葉(&amp;M)</translation>
    </message>
    <message>
        <source>Ans&amp;wers on the back</source>
        <translation>裏に答え(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Vertical writing</source>
        <translation>縦書き(&amp;V)</translation>
    </message>
    <message>
        <source>Folded &amp;booklet</source>
        <translation>二つ折りの冊子(&amp;B)</translation>
    </message>
    <message>
        <source>L&amp;ine for name, class and date</source>
        <translation>名前、組、日付の欄(&amp;I)</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>題名</translation>
    </message>
    <message>
        <source>Titl&amp;e</source>
        <translation>題名(&amp;E)</translation>
    </message>
    <message>
        <source>Lang&amp;uage of the sheet</source>
        <translation>プリントの言語(&amp;U)</translation>
    </message>
    <message>
        <source>English</source>
        <translation>英語</translation>
    </message>
    <message>
        <source>Japanese</source>
        <translation>日本語</translation>
    </message>
</context>
<context>
    <name>nazori::ui::WorkshopActions</name>
    <message>
        <source>&amp;Draw strokes</source>
        <translation>画をかく(&amp;D)</translation>
    </message>
    <message>
        <source>Draw strokes with pen or mouse; pressure makes them wider</source>
        <translation>ペンかマウスで画をかきます。筆圧で太くなります</translation>
    </message>
    <message>
        <source>&amp;Place points</source>
        <translation>点を置く(&amp;P)</translation>
    </message>
    <message>
        <source>Click the start, the bends and the end of a stroke. Enter: finish it</source>
        <translation>画の書き始め、曲がり角、終わりをクリックします。Enter で完成します</translation>
    </message>
    <message>
        <source>&amp;Edit strokes</source>
        <translation>画を直す(&amp;E)</translation>
    </message>
    <message>
        <source>Choose and move points and strokes</source>
        <translation>点や画を選んで動かします</translation>
    </message>
    <message>
        <source>&amp;Groove</source>
        <translation>溝(&amp;G)</translation>
    </message>
    <message>
        <source>Cut a groove into the relief by hand</source>
        <translation>手で溝を彫ります</translation>
    </message>
    <message>
        <source>&amp;Raise</source>
        <translation>盛り上げる(&amp;R)</translation>
    </message>
    <message>
        <source>Raise the relief by hand</source>
        <translation>手で面を盛り上げます</translation>
    </message>
    <message>
        <source>S&amp;mooth</source>
        <translation>ならす(&amp;M)</translation>
    </message>
    <message>
        <source>Even out the relief</source>
        <translation>面をなめらかにします</translation>
    </message>
    <message>
        <source>E&amp;rase</source>
        <translation>元に戻す(&amp;R)</translation>
    </message>
    <message>
        <source>Take back what was cut or raised by hand; strokes stay</source>
        <translation>手で彫った所や盛った所を元に戻します。画は残ります</translation>
    </message>
    <message>
        <source>Sta&amp;mp</source>
        <translation>型押し(&amp;M)</translation>
    </message>
    <message>
        <source>Press a shape into the relief</source>
        <translation>面に形を押します</translation>
    </message>
    <message>
        <source>Straight &amp;lines</source>
        <translation>直線にする(&amp;L)</translation>
    </message>
    <message>
        <source>Every stroke becomes one straight line</source>
        <translation>画が1本の直線になります</translation>
    </message>
    <message>
        <source>M&amp;irrored</source>
        <translation>左右対称(&amp;I)</translation>
    </message>
    <message>
        <source>The tools for the relief work on both sides of the middle</source>
        <translation>面の道具が中央線の両側で働きます</translation>
    </message>
    <message>
        <source>&amp;Wider</source>
        <translation>太く(&amp;W)</translation>
    </message>
    <message>
        <source>Make the chosen stroke or point, or else the tool, wider</source>
        <translation>選んだ画か点を、なければ道具を太くします</translation>
    </message>
    <message>
        <source>&amp;Thinner</source>
        <translation>細く(&amp;T)</translation>
    </message>
    <message>
        <source>Make the chosen stroke or point, or else the tool, thinner</source>
        <translation>選んだ画か点を、なければ道具を細くします</translation>
    </message>
    <message>
        <source>Dee&amp;per</source>
        <translation>深く(&amp;P)</translation>
    </message>
    <message>
        <source>Make the chosen stroke or point, or else the tool, deeper</source>
        <translation>選んだ画か点を、なければ道具を深くします</translation>
    </message>
    <message>
        <source>S&amp;hallower</source>
        <translation>浅く(&amp;H)</translation>
    </message>
    <message>
        <source>Make the chosen stroke or point, or else the tool, shallower</source>
        <translation>選んだ画か点を、なければ道具を浅くします</translation>
    </message>
    <message>
        <source>&amp;Other stamp</source>
        <translation>ほかの型(&amp;O)</translation>
    </message>
    <message>
        <source>Take the next shape for the stamp</source>
        <translation>次の形の型に替えます</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>取り消す(&amp;U)</translation>
    </message>
    <message>
        <source>Undo the last change</source>
        <translation>最後の変更を取り消します</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>やり直す(&amp;R)</translation>
    </message>
    <message>
        <source>Redo what was undone</source>
        <translation>取り消した変更をやり直します</translation>
    </message>
    <message>
        <source>Take the last point &amp;back</source>
        <translation>最後の点を消す(&amp;B)</translation>
    </message>
    <message>
        <source>Remove the point that was placed last; without one, undo</source>
        <translation>最後に置いた点を消します。なければ変更を取り消します</translation>
    </message>
    <message>
        <source>&amp;Finish the stroke</source>
        <translation>画を完成する(&amp;F)</translation>
    </message>
    <message>
        <source>Make a stroke of the placed points</source>
        <translation>置いた点を画にします</translation>
    </message>
    <message>
        <source>&amp;Next stroke</source>
        <translation>次の画(&amp;N)</translation>
    </message>
    <message>
        <source>Choose the next stroke</source>
        <translation>次の画を選びます</translation>
    </message>
    <message>
        <source>Pre&amp;vious stroke</source>
        <translation>前の画(&amp;V)</translation>
    </message>
    <message>
        <source>Choose the previous stroke</source>
        <translation>前の画を選びます</translation>
    </message>
    <message>
        <source>Ne&amp;xt point</source>
        <translation>次の点(&amp;X)</translation>
    </message>
    <message>
        <source>Choose the next point of the stroke</source>
        <translation>画の次の点を選びます</translation>
    </message>
    <message>
        <source>Previous p&amp;oint</source>
        <translation>前の点(&amp;O)</translation>
    </message>
    <message>
        <source>Choose the previous point of the stroke</source>
        <translation>画の前の点を選びます</translation>
    </message>
    <message>
        <source>&amp;Earlier</source>
        <translation>書き順を前へ(&amp;E)</translation>
    </message>
    <message>
        <source>Move the stroke one place forward in the order</source>
        <translation>画の書き順を一つ早くします</translation>
    </message>
    <message>
        <source>&amp;Later</source>
        <translation>書き順を後へ(&amp;L)</translation>
    </message>
    <message>
        <source>Move the stroke one place back in the order</source>
        <translation>画の書き順を一つ遅くします</translation>
    </message>
    <message>
        <source>Re&amp;verse</source>
        <translation>向きを逆に(&amp;V)</translation>
    </message>
    <message>
        <source>Draw the stroke from its other end</source>
        <translation>画を反対の端から書きます</translation>
    </message>
    <message>
        <source>Other en&amp;ding</source>
        <translation>ほかの終わり方(&amp;D)</translation>
    </message>
    <message>
        <source>Give the stroke another ending: stop, hook, sweep</source>
        <translation>画の終わり方を変えます：とめ、はね、はらい</translation>
    </message>
    <message>
        <source>&amp;Insert a point</source>
        <translation>点を加える(&amp;I)</translation>
    </message>
    <message>
        <source>Add a point after the chosen one. With the mouse: double-click the line</source>
        <translation>選んだ点の次に点を加えます。マウスでは線をダブルクリックします</translation>
    </message>
    <message>
        <source>&amp;Split</source>
        <translation>分ける(&amp;S)</translation>
    </message>
    <message>
        <source>Split the stroke at the chosen point</source>
        <translation>選んだ点で画を二つに分けます</translation>
    </message>
    <message>
        <source>&amp;Join</source>
        <translation>つなぐ(&amp;J)</translation>
    </message>
    <message>
        <source>Join the next stroke to the end of this one</source>
        <translation>次の画をこの画の終わりにつなぎます</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>削除(&amp;D)</translation>
    </message>
    <message>
        <source>Delete the chosen point or stroke</source>
        <translation>選んだ点か画を削除します</translation>
    </message>
    <message>
        <source>&amp;New character</source>
        <translation>新しい文字(&amp;N)</translation>
    </message>
    <message>
        <source>Begin with an empty tablet</source>
        <translation>何もない文字板から始めます</translation>
    </message>
    <message>
        <source>&amp;Copy of the character shown</source>
        <translation>表示中の文字の複製(&amp;C)</translation>
    </message>
    <message>
        <source>Begin with a copy of the character that was shown last</source>
        <translation>最後に表示した文字の複製から始めます</translation>
    </message>
    <message>
        <source>From a &amp;picture…</source>
        <translation>画像から(&amp;P)…</translation>
    </message>
    <message>
        <source>Find the strokes in a scan or photograph (PNG, JPEG)</source>
        <translation>スキャンや写真（PNG、JPEG）から画を見つけます</translation>
    </message>
    <message>
        <source>From a &amp;font…</source>
        <translation>フォントから(&amp;F)…</translation>
    </message>
    <message>
        <source>Find the strokes of a character of a font</source>
        <translation>フォントの文字から画を見つけます</translation>
    </message>
    <message>
        <source>Clear the &amp;relief</source>
        <translation>手の加工を消す(&amp;R)</translation>
    </message>
    <message>
        <source>Take away everything that was changed by hand; strokes stay</source>
        <translation>手で加えた変更をすべて消します。画は残ります</translation>
    </message>
    <message>
        <source>&amp;Name and details</source>
        <translation>名前と詳細(&amp;N)</translation>
    </message>
    <message>
        <source>Type the name, readings and licence</source>
        <translation>名前、読み、ライセンスを入力します</translation>
    </message>
    <message>
        <source>Chec&amp;k</source>
        <translation>点検(&amp;K)</translation>
    </message>
    <message>
        <source>Look for mistakes: order, endings, depth, licence</source>
        <translation>書き順、終わり方、深さ、ライセンスの誤りを探します</translation>
    </message>
    <message>
        <source>De&amp;scribe</source>
        <translation>説明(&amp;S)</translation>
    </message>
    <message>
        <source>Say what is chosen and what the character has</source>
        <translation>選んだものと文字の内容を読み上げます</translation>
    </message>
    <message>
        <source>&amp;Feel it</source>
        <translation>触ってみる(&amp;F)</translation>
    </message>
    <message>
        <source>Carve the character as the tablet that you feel</source>
        <translation>この文字を、触れる文字板に彫ります</translation>
    </message>
    <message>
        <source>Save a cop&amp;y…</source>
        <translation>別の形式で保存(&amp;Y)…</translation>
    </message>
    <message>
        <source>Save as SVG, stroke order, height map (RAW, PNG)</source>
        <translation>SVG、書き順、高さマップ（RAW、PNG）で保存します</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>拡大(&amp;I)</translation>
    </message>
    <message>
        <source>Show less, larger</source>
        <translation>一部を大きく表示します</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>縮小(&amp;O)</translation>
    </message>
    <message>
        <source>Show more, smaller</source>
        <translation>広い範囲を小さく表示します</translation>
    </message>
    <message>
        <source>&amp;Whole tablet</source>
        <translation>全体(&amp;W)</translation>
    </message>
    <message>
        <source>Show the whole tablet</source>
        <translation>文字板全体を表示します</translation>
    </message>
    <message>
        <source>Show &amp;strokes</source>
        <translation>画を表示(&amp;S)</translation>
    </message>
    <message>
        <source>Show the strokes over the relief</source>
        <translation>面の上に画を表示します</translation>
    </message>
    <message>
        <source>&amp;Strokes and details</source>
        <translation>画と詳細(&amp;S)</translation>
    </message>
    <message>
        <source>Show or hide the panel</source>
        <translation>パネルを表示または隠します</translation>
    </message>
    <message>
        <source>&amp;Tool</source>
        <translation>道具(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Stroke</source>
        <translation>画(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Character</source>
        <translation>文字(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Look</source>
        <translation>見え方(&amp;L)</translation>
    </message>
    <message>
        <source>N&amp;umber</source>
        <translation>番号(&amp;U)</translation>
    </message>
    <message>
        <source>Choose the number of the stroke. Arrow keys or the mouse move it</source>
        <translation>画の番号を選びます。矢印キーやマウスで動かせます</translation>
    </message>
    <message>
        <source>Place the number a&amp;utomatically</source>
        <translation>番号を自動で置く(&amp;U)</translation>
    </message>
    <message>
        <source>Let the program place the number of the stroke again</source>
        <translation>画の番号の位置をもう一度自動で決めます</translation>
    </message>
    <message>
        <source>&amp;Width and depth along the stroke</source>
        <translation>画に沿った太さと深さ(&amp;W)</translation>
    </message>
    <message>
        <source>Change width and depth along the stroke: Left and Right choose a point, Up and Down change it</source>
        <translation>画に沿って太さと深さを変えます。左右キーで点を選び、上下キーで変えます</translation>
    </message>
    <message>
        <source>From a function p&amp;lot…</source>
        <translation>関数のグラフから(&amp;L)…</translation>
    </message>
    <message>
        <source>Begin with the plot of a function as the relief</source>
        <translation>関数のグラフを彫ったものから始めます</translation>
    </message>
    <message>
        <source>&amp;Keep among my characters</source>
        <translation>自作の文字に登録(&amp;K)</translation>
    </message>
    <message>
        <source>Lists, search, study and worksheets have it then like any other</source>
        <translation>一覧・検索・学習・プリントで、ほかの文字と同じように使えます</translation>
    </message>
    <message>
        <source>Ta&amp;ke out of my characters</source>
        <translation>自作の文字から外す(&amp;K)</translation>
    </message>
    <message>
        <source>Lists, search, study and worksheets no longer have it; what you learned stays</source>
        <translation>一覧・検索・学習・プリントから外します。学習の記録は残ります</translation>
    </message>
    <message>
        <source>&amp;Add a part</source>
        <translation>パーツを加える(&amp;A)</translation>
    </message>
    <message>
        <source>Add a part of the strokes that are chosen in the list, or else of those in no part</source>
        <translation>一覧で選んだ画、なければどのパーツにも入っていない画を、パーツとして加えます</translation>
    </message>
    <message>
        <source>Rem&amp;ove the part</source>
        <translation>パーツを外す(&amp;O)</translation>
    </message>
    <message>
        <source>Remove the chosen part; strokes stay</source>
        <translation>選んだパーツを外します。画は残ります</translation>
    </message>
    <message>
        <source>&amp;Use instead of the published one</source>
        <translation>標準の字形の代わりに使う(&amp;U)</translation>
    </message>
    <message>
        <source>Use this form instead of the published character of its name</source>
        <translation>名前と同じ文字の標準の字形の代わりに、この字形を使います</translation>
    </message>
</context>
<context>
    <name>nazori::ui::WorkshopPage</name>
    <message>
        <source>Place at least two points first: the start and the end.</source>
        <translation>先に書き始めと終わりの2点を置いてください。</translation>
    </message>
    <message>
        <source>An empty tablet. Draw the first stroke.</source>
        <translation>何もない文字板です。1画目をかいてください。</translation>
    </message>
    <message>
        <source>Tool: %1.</source>
        <translation>道具：%1。</translation>
    </message>
    <message>
        <source>Width: %1 of 109.</source>
        <translation>太さ：109分の%1。</translation>
    </message>
    <message>
        <source>Depth: %1%.</source>
        <translation>深さ：%1%。</translation>
    </message>
    <message>
        <source>Stamp: %1.</source>
        <translation>型：%1。</translation>
    </message>
    <message>
        <source>Ending: %1.</source>
        <translation>終わり方：%1。</translation>
    </message>
    <message>
        <source>Ending of placed strokes: %1.</source>
        <translation>点を置いた画の終わり方：%1。</translation>
    </message>
    <message>
        <source>There are no strokes yet.</source>
        <translation>まだ画がありません。</translation>
    </message>
    <message>
        <source>This is not possible here.</source>
        <translation>ここではできません。</translation>
    </message>
    <message>
        <source>Choose a stroke first. N: next stroke. Full stop: next point.</source>
        <translation>先に画を選んでください。N：次の画。ピリオド：次の点。</translation>
    </message>
    <message>
        <source>Checked: nothing was found.</source>
        <translation>点検しました。問題はありません。</translation>
    </message>
    <message>
        <source>Not saved.</source>
        <translation>保存していません。</translation>
    </message>
    <message>
        <source>This is not possible: %1.</source>
        <translation>できません：%1。</translation>
    </message>
    <message>
        <source>Own character</source>
        <translation>作った文字</translation>
    </message>
    <message>
        <source>Your changes cannot be kept for an emergency: %1.</source>
        <translation>変更を自動保存できません：%1。</translation>
    </message>
    <message>
        <source>Work that was interrupted could not be brought back: %1.</source>
        <translation>中断した作業を復元できませんでした：%1。</translation>
    </message>
    <message numerus="yes">
        <source>Your work that was interrupted is back: %n changes.</source>
        <translation>
            <numerusform>中断した作業を復元しました：変更%n件。</numerusform>
        </translation>
    </message>
    <message>
        <source>The character in the workshop is not saved.</source>
        <translation>工房の文字を保存していません。</translation>
    </message>
    <message>
        <source>Could not open %1: %2.</source>
        <translation>%1 を開けません：%2。</translation>
    </message>
    <message numerus="yes">
        <source>Opened %1, with %n changes that were not saved.</source>
        <translation>
            <numerusform>%1 を開き、保存していなかった変更%n件を復元しました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Opened %1.</source>
        <translation>%1 を開きました。</translation>
    </message>
    <message>
        <source>Open a character</source>
        <translation>文字を開く</translation>
    </message>
    <message>
        <source>All of these (*.nazori *.svg *.str *.raw *.png)</source>
        <translation>すべて (*.nazori *.svg *.str *.raw *.png)</translation>
    </message>
    <message>
        <source>Character (*.nazori)</source>
        <translation>文字 (*.nazori)</translation>
    </message>
    <message>
        <source>Strokes (*.svg *.str)</source>
        <translation>画 (*.svg *.str)</translation>
    </message>
    <message>
        <source>Height map (*.raw *.png)</source>
        <translation>高さマップ (*.raw *.png)</translation>
    </message>
    <message>
        <source>character</source>
        <translation>文字</translation>
    </message>
    <message>
        <source>Save the character</source>
        <translation>文字を保存</translation>
    </message>
    <message>
        <source>Save a copy</source>
        <translation>別の形式で保存</translation>
    </message>
    <message>
        <source>Strokes as a drawing (*.svg)</source>
        <translation>画の図 (*.svg)</translation>
    </message>
    <message>
        <source>Stroke order of 2005 (*.str)</source>
        <translation>2005年版の書き順 (*.str)</translation>
    </message>
    <message>
        <source>Height map, 8 bits (*.raw)</source>
        <translation>高さマップ、8ビット (*.raw)</translation>
    </message>
    <message>
        <source>Height map, 16 bits (*.png)</source>
        <translation>高さマップ、16ビット (*.png)</translation>
    </message>
    <message>
        <source>Could not save %1: %2.</source>
        <translation>%1 を保存できません：%2。</translation>
    </message>
    <message>
        <source>Saved %1.</source>
        <translation>%1 を保存しました。</translation>
    </message>
    <message>
        <source>Saved a copy as %1.</source>
        <translation>%1 に保存しました。</translation>
    </message>
    <message>
        <source>A copy of %1. Change what you like.</source>
        <translation>%1の複製です。自由に直せます。</translation>
    </message>
    <message>
        <source>The database has no strokes of %1.</source>
        <translation>データベースに%1の画がありません。</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes found in %1.</source>
        <translation>
            <numerusform>%1 から%n画が見つかりました。</numerusform>
        </translation>
    </message>
    <message>
        <source>Look at these: %1. Little ink was found for them.</source>
        <translation>%1画目を確かめてください。線がほとんど見つかりませんでした。</translation>
    </message>
    <message>
        <source>No strokes were found: %1. The character was not changed.</source>
        <translation>画が見つかりません：%1。文字は変わっていません。</translation>
    </message>
    <message>
        <source>Looking for strokes…</source>
        <translation>画を探しています…</translation>
    </message>
    <message>
        <source>Find the strokes of a picture</source>
        <translation>画像から画を見つける</translation>
    </message>
    <message>
        <source>&amp;Workshop</source>
        <translation>工房(&amp;W)</translation>
    </message>
    <message>
        <source>Make your own characters and signs</source>
        <translation>自分の文字や記号を作ります</translation>
    </message>
    <message>
        <source>Draw strokes with mouse or pen. 1 to 8: tools. K: check. S: describe what is there.</source>
        <translation>マウスかペンで画をかきます。1～8：道具。K：点検。S：内容の説明。</translation>
    </message>
    <message>
        <source>Point %1 placed. Enter: finish the stroke.</source>
        <translation>%1番目の点を置きました。Enter：画を完成。</translation>
    </message>
    <message>
        <source>Pen down. Move it with the arrow keys; space lifts it.</source>
        <translation>ペンを下ろしました。矢印キーで動かし、スペースで上げます。</translation>
    </message>
    <message>
        <source>Cursor: %1 from the left and %2 from the top, of 109.</source>
        <translation>カーソルは左から%1、上から%2です（全体は109）。</translation>
    </message>
    <message>
        <source>Draw a stroke first: there is nothing yet that could be written.</source>
        <translation>まず一画書いてください。書けるものがまだありません。</translation>
    </message>
    <message>
        <source>Give the character a name first.</source>
        <translation>先に文字の名前を入力してください。</translation>
    </message>
    <message>
        <source>The character could not be kept: %1.</source>
        <translation>文字を登録できませんでした：%1。</translation>
    </message>
    <message>
        <source>There is a character called “%1” among yours already.</source>
        <translation>「%1」という名前の文字はすでに登録されています。</translation>
    </message>
    <message>
        <source>Replace it</source>
        <translation>置き換える</translation>
    </message>
    <message>
        <source>Keep both</source>
        <translation>両方残す</translation>
    </message>
    <message>
        <source>Go back</source>
        <translation>戻る</translation>
    </message>
    <message>
        <source>“%1” is among your characters now: in lists, search, study and worksheets.</source>
        <translation>「%1」を自作の文字に登録しました。一覧・検索・学習・プリントで使えます。</translation>
    </message>
    <message>
        <source>This is not one of your kept characters. Open one of them with C first.</source>
        <translation>登録した文字ではありません。先にCキーで登録した文字を開いてください。</translation>
    </message>
    <message>
        <source>Take “%1” out of your characters? What you learned of it stays.</source>
        <translation>「%1」を自作の文字から外しますか？ 学習の記録は残ります。</translation>
    </message>
    <message>
        <source>Take it out</source>
        <translation>外す</translation>
    </message>
    <message>
        <source>The character could not be taken out: %1.</source>
        <translation>文字を外せませんでした：%1。</translation>
    </message>
    <message>
        <source>“%1” is no longer among your characters. A keeps it again.</source>
        <translation>「%1」を自作の文字から外しました。Aキーでもう一度登録できます。</translation>
    </message>
    <message>
        <source>The program places the number.</source>
        <translation>番号は自動で置かれます。</translation>
    </message>
    <message>
        <source>Choose a part in the list first.</source>
        <translation>先に一覧でパーツを選んでください。</translation>
    </message>
    <message>
        <source>The relief is the plot of %1.</source>
        <translation>%1 のグラフを彫りました。</translation>
    </message>
    <message>
        <source>Use it instead</source>
        <translation>代わりに使う</translation>
    </message>
    <message>
        <source>Keep it beside</source>
        <translation>別の文字として登録</translation>
    </message>
    <message>
        <source>%1 is a published character. Use your form instead of the published one? Lists, study and worksheets then have your strokes, and the study history goes on. Taking it out brings the published form back.</source>
        <translation>%1 には標準の字形があります。その代わりに、作った字形を使いますか。一覧・学習・プリントが作った字形になり、学習履歴はそのまま続きます。自作の文字から外すと標準の字形に戻ります。</translation>
    </message>
    <message>
        <source>Only a form of a published character can be used instead of it: give it that name. D: name.</source>
        <translation>代わりに使えるのは、収録されている文字の字形だけです。名前をその文字にしてください。Dキーで名前を入力できます。</translation>
    </message>
    <message>
        <source>Once kept (A), it stands beside the published %1.</source>
        <translation>Aキーで登録し直すと、標準の %1 とは別の文字になります。</translation>
    </message>
    <message>
        <source>Once kept (A), it is used instead of the published %1.</source>
        <translation>Aキーで登録すると、標準の %1 の代わりに使われます。</translation>
    </message>
    <message>
        <source>Saving…</source>
        <translation>保存しています…</translation>
    </message>
    <message>
        <source>Your form is used instead of the published %1 now: in lists, search, study and worksheets.</source>
        <translation>一覧・検索・学習・プリントで、標準の %1 の代わりに作った字形を使います。</translation>
    </message>
    <message>
        <source>The published %1 is used again. Your form is still here; A keeps it again.</source>
        <translation>標準の %1 に戻りました。作った字形はここに残っています。Aキーでもう一度登録できます。</translation>
    </message>
    <message>
        <source>Opening %1…</source>
        <translation>%1 を開いています…</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg *.svg)</source>
        <translation>画像 (*.png *.jpg *.jpeg *.svg)</translation>
    </message>
</context>
<context>
    <name>nazori::ui::WorkshopPanel</name>
    <message>
        <source>Strokes and details</source>
        <translation>画と詳細</translation>
    </message>
    <message>
        <source>Tool</source>
        <translation>道具</translation>
    </message>
    <message>
        <source>Width of the tool</source>
        <translation>道具の太さ</translation>
    </message>
    <message>
        <source>Depth of the tool</source>
        <translation>道具の深さ</translation>
    </message>
    <message>
        <source> %</source>
        <translation> %</translation>
    </message>
    <message>
        <source>Ending of placed strokes</source>
        <translation>点を置いた画の終わり方</translation>
    </message>
    <message>
        <source>Shape of the stamp</source>
        <translation>型の形</translation>
    </message>
    <message>
        <source>Width (of 109)</source>
        <translation>太さ（109分の）</translation>
    </message>
    <message>
        <source>Depth</source>
        <translation>深さ</translation>
    </message>
    <message>
        <source>Ending</source>
        <translation>終わり方</translation>
    </message>
    <message>
        <source>Stamp</source>
        <translation>型押し</translation>
    </message>
    <message>
        <source>Strokes</source>
        <translation>画</translation>
    </message>
    <message>
        <source>Strokes in writing order</source>
        <translation>書き順に並んだ画</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>詳細</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>名前</translation>
    </message>
    <message>
        <source>A character, or what you call it</source>
        <translation>文字、または呼び名</translation>
    </message>
    <message>
        <source>Readings</source>
        <translation>読み</translation>
    </message>
    <message>
        <source>With commas between them</source>
        <translation>読点で区切ります</translation>
    </message>
    <message>
        <source>Meanings</source>
        <translation>意味</translation>
    </message>
    <message>
        <source>Author</source>
        <translation>作者</translation>
    </message>
    <message>
        <source>Licence</source>
        <translation>ライセンス</translation>
    </message>
    <message>
        <source>Check</source>
        <translation>点検</translation>
    </message>
    <message>
        <source>What the check found</source>
        <translation>点検の結果</translation>
    </message>
    <message>
        <source>Source: %1</source>
        <translation>出典：%1</translation>
    </message>
    <message>
        <source>Not checked yet.</source>
        <translation>まだ点検していません。</translation>
    </message>
    <message>
        <source>✓ Nothing was found.</source>
        <translation>✓ 問題はありません。</translation>
    </message>
    <message numerus="yes">
        <source>%n remarks</source>
        <translation>
            <numerusform>指摘%n件</numerusform>
        </translation>
    </message>
    <message>
        <source>Radical</source>
        <translation>部首</translation>
    </message>
    <message>
        <source>Parts</source>
        <translation>パーツ</translation>
    </message>
    <message>
        <source>“%1” is not a radical. Type its number, 1 to 214, or its form.</source>
        <translation>「%1」は部首ではありません。番号（1〜214）か形を入力してください。</translation>
    </message>
    <message>
        <source>1 to 214, or a form</source>
        <translation>1〜214、または形</translation>
    </message>
</context>
<context>
    <name>nazori::ui::WorkshopWords</name>
    <message>
        <source>stroke drawn</source>
        <translation>画の追加</translation>
    </message>
    <message>
        <source>strokes added</source>
        <translation>画の追加</translation>
    </message>
    <message>
        <source>stroke deleted</source>
        <translation>画の削除</translation>
    </message>
    <message>
        <source>point added</source>
        <translation>点の追加</translation>
    </message>
    <message>
        <source>point moved</source>
        <translation>点の移動</translation>
    </message>
    <message>
        <source>point deleted</source>
        <translation>点の削除</translation>
    </message>
    <message>
        <source>stroke moved</source>
        <translation>画の移動</translation>
    </message>
    <message>
        <source>stroke split</source>
        <translation>画の分割</translation>
    </message>
    <message>
        <source>strokes joined</source>
        <translation>画の結合</translation>
    </message>
    <message>
        <source>stroke reversed</source>
        <translation>向きの逆転</translation>
    </message>
    <message>
        <source>order changed</source>
        <translation>書き順の変更</translation>
    </message>
    <message>
        <source>ending changed</source>
        <translation>終わり方の変更</translation>
    </message>
    <message>
        <source>width changed</source>
        <translation>太さの変更</translation>
    </message>
    <message>
        <source>depth changed</source>
        <translation>深さの変更</translation>
    </message>
    <message>
        <source>number moved</source>
        <translation>番号の移動</translation>
    </message>
    <message>
        <source>details changed</source>
        <translation>詳細の変更</translation>
    </message>
    <message>
        <source>groove cut</source>
        <translation>溝彫り</translation>
    </message>
    <message>
        <source>relief raised</source>
        <translation>盛り上げ</translation>
    </message>
    <message>
        <source>relief smoothed</source>
        <translation>ならし</translation>
    </message>
    <message>
        <source>relief erased</source>
        <translation>元に戻す加工</translation>
    </message>
    <message>
        <source>stamp pressed</source>
        <translation>型押し</translation>
    </message>
    <message>
        <source>height map loaded</source>
        <translation>高さマップの読み込み</translation>
    </message>
    <message>
        <source>relief cleared</source>
        <translation>手の加工の消去</translation>
    </message>
    <message>
        <source>Draw strokes</source>
        <translation>画をかく</translation>
    </message>
    <message>
        <source>Place points</source>
        <translation>点を置く</translation>
    </message>
    <message>
        <source>Edit strokes</source>
        <translation>画を直す</translation>
    </message>
    <message>
        <source>Groove</source>
        <translation>溝</translation>
    </message>
    <message>
        <source>Raise</source>
        <translation>盛り上げる</translation>
    </message>
    <message>
        <source>Smooth</source>
        <translation>ならす</translation>
    </message>
    <message>
        <source>Erase</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>Stamp</source>
        <translation>型押し</translation>
    </message>
    <message>
        <source>Dot</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Ring</source>
        <translation>輪</translation>
    </message>
    <message>
        <source>Bar</source>
        <translation>棒</translation>
    </message>
    <message>
        <source>Cross</source>
        <translation>十字</translation>
    </message>
    <message>
        <source>Square</source>
        <translation>四角</translation>
    </message>
    <message>
        <source>Triangle</source>
        <translation>三角</translation>
    </message>
    <message>
        <source>stop</source>
        <translation>とめ</translation>
    </message>
    <message>
        <source>hook</source>
        <translation>はね</translation>
    </message>
    <message>
        <source>sweep</source>
        <translation>はらい</translation>
    </message>
    <message>
        <source>any ending</source>
        <translation>終わり方は自由</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>取り消す変更はありません。</translation>
    </message>
    <message>
        <source>Undone: %1.</source>
        <translation>取り消しました：%1。</translation>
    </message>
    <message>
        <source>There is nothing to redo.</source>
        <translation>やり直す変更はありません。</translation>
    </message>
    <message>
        <source>Redone: %1.</source>
        <translation>やり直しました：%1。</translation>
    </message>
    <message>
        <source>.</source>
        <translation>。</translation>
    </message>
    <message>
        <source>Stroke %1 of %2, %3, %4.</source>
        <translation>全%2画の%1画目、%3、%4。</translation>
    </message>
    <message numerus="yes">
        <source>%n points</source>
        <translation>
            <numerusform>点%n個</numerusform>
        </translation>
    </message>
    <message>
        <source>Point %1</source>
        <translation>%1番目の点</translation>
    </message>
    <message>
        <source>Start</source>
        <translation>書き始め</translation>
    </message>
    <message>
        <source>End</source>
        <translation>終わり</translation>
    </message>
    <message>
        <source>%1: %2 from the left, %3 from the top, %4 wide.</source>
        <translation>%1：左から%2、上から%3、太さ%4。</translation>
    </message>
    <message>
        <source>No name yet</source>
        <translation>名前なし</translation>
    </message>
    <message>
        <source>: </source>
        <translation>：</translation>
    </message>
    <message>
        <source>no strokes.</source>
        <translation>画がありません。</translation>
    </message>
    <message numerus="yes">
        <source>%n strokes.</source>
        <translation>
            <numerusform>全%n画。</numerusform>
        </translation>
    </message>
    <message>
        <source>The relief was changed by hand.</source>
        <translation>手で面を加工しています。</translation>
    </message>
    <message>
        <source>%1  %2</source>
        <translation>%1&#x3000;%2</translation>
    </message>
    <message>
        <source>There are no strokes.</source>
        <translation>画がありません。</translation>
    </message>
    <message>
        <source>The character has no name.</source>
        <translation>文字に名前がありません。</translation>
    </message>
    <message>
        <source>Stroke %1: its number is far from its start.</source>
        <translation>%1画目：番号が書き始めから離れています。</translation>
    </message>
    <message>
        <source>The numbers of strokes %1 and %2 cover each other.</source>
        <translation>%1画目と%2画目の番号が重なっています。</translation>
    </message>
    <message>
        <source>The number of stroke %1 covers the start of stroke %2.</source>
        <translation>%1画目の番号が%2画目の書き始めを隠しています。</translation>
    </message>
    <message>
        <source>The part %1 has no strokes.</source>
        <translation>パーツ%1に画がありません。</translation>
    </message>
    <message>
        <source>Stroke %1 belongs to no part.</source>
        <translation>%1画目がどのパーツにも入っていません。</translation>
    </message>
    <message>
        <source>Stroke %1 leaves the tablet.</source>
        <translation>%1画目が文字板からはみ出しています。</translation>
    </message>
    <message>
        <source>Stroke %1 has no length.</source>
        <translation>%1画目に長さがありません。</translation>
    </message>
    <message>
        <source>Strokes %1 and %2 lie on each other.</source>
        <translation>%1画目と%2画目が重なっています。</translation>
    </message>
    <message>
        <source>Stroke %1: its ending does not look as it is said to be.</source>
        <translation>%1画目：終わり方が形と合っていません。</translation>
    </message>
    <message>
        <source>Stroke %1: the line turns back sharply at a point.</source>
        <translation>%1画目：線が急に折り返しています。</translation>
    </message>
    <message>
        <source>Stroke %1 is too shallow to feel.</source>
        <translation>%1画目は浅すぎて触っても分かりません。</translation>
    </message>
    <message>
        <source>Stroke %1 is narrower than the tip of a stylus.</source>
        <translation>%1画目はペン先より細くなっています。</translation>
    </message>
    <message>
        <source>The wall between strokes %1 and %2 is too thin to feel (%3 of 109).</source>
        <translation>%1画目と%2画目の間の壁が薄すぎます（109分の%3）。</translation>
    </message>
    <message>
        <source>The dictionary counts %1 strokes.</source>
        <translation>辞書では%1画です。</translation>
    </message>
    <message>
        <source>A copy of a character of KanjiVG must name KanjiVG&apos;s licence and authors.</source>
        <translation>KanjiVG の文字の複製には、KanjiVG のライセンスと作者の記載が必要です。</translation>
    </message>
    <message>
        <source>No licence is named. Others will not know what they may do with it.</source>
        <translation>ライセンスがありません。ほかの人がどう使ってよいか分かりません。</translation>
    </message>
    <message>
        <source>The SVG is not as KanjiVG&apos;s tools expect it.</source>
        <translation>SVG が KanjiVG の道具の求める形になっていません。</translation>
    </message>
    <message>
        <source>Its number: %1 from the left, %2 from the top, %3.</source>
        <translation>番号の位置：左から%1、上から%2、%3。</translation>
    </message>
    <message>
        <source>placed by hand</source>
        <translation>手で置いた位置</translation>
    </message>
    <message>
        <source>placed by the program</source>
        <translation>自動の位置</translation>
    </message>
    <message>
        <source>Used instead of the published %1.</source>
        <translation>標準の %1 の代わりに使われます。</translation>
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
        <source>Feedback on your writing</source>
        <translation>書いた字の講評</translation>
    </message>
    <message>
        <source>Not quite</source>
        <translation>もう少し</translation>
    </message>
    <message>
        <source>Correct</source>
        <translation>正解</translation>
    </message>
    <message>
        <source>Correct. Form: %1</source>
        <translation>正解。字形：%1</translation>
    </message>
    <message>
        <source>Correct. Form: %1 of %2 stars</source>
        <translation>正解。字形は星%2つ中%1つ</translation>
    </message>
</context>
<context>
    <name>nazori::ui::YearView</name>
    <message>
        <source>%1, today: no study yet</source>
        <translation>%1、今日：まだ学習していません</translation>
    </message>
    <message>
        <source>%1: no study</source>
        <translation>%1：学習なし</translation>
    </message>
    <message>
        <source>from memory %1</source>
        <translation>見ないで書いた%1回</translation>
    </message>
    <message>
        <source>practised %1</source>
        <translation>練習%1回</translation>
    </message>
    <message>
        <source>new %1</source>
        <translation>新しい字%1字</translation>
    </message>
    <message>
        <source>%1, today: %2</source>
        <translation>%1、今日：%2</translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation>%1：%2</translation>
    </message>
    <message>
        <source>, </source>
        <translation>、</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <comment>times</comment>
        <translation>%1～%2</translation>
    </message>
    <message>
        <source>%1 or more</source>
        <comment>times</comment>
        <translation>%1以上</translation>
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
        <source>The curve is vertical here.</source>
        <translation>ここでは曲線が垂直です。</translation>
    </message>
    <message>
        <source>slope %1</source>
        <translation>傾き %1</translation>
    </message>
    <message>
        <source>x from %1 to %2, one tick is %3; y from %4 to %5, one tick is %6</source>
        <translation>x は %1 から %2、1目盛りは %3。y は %4 から %5、1目盛りは %6</translation>
    </message>
    <message>
        <source>There is no other curve or branch.</source>
        <translation>ほかの曲線や枝はありません。</translation>
    </message>
    <message>
        <source>Next branch</source>
        <translation>次のパーツ</translation>
    </message>
    <message>
        <source>End</source>
        <translation>端</translation>
    </message>
    <message>
        <source>Marker %1</source>
        <translation>目印 %1</translation>
    </message>
    <message>
        <source>Marker %1 set: %2.</source>
        <translation>目印 %1 をここに置きました：%2。</translation>
    </message>
    <message>
        <source>Only curve %1: %2.</source>
        <translation>曲線 %1 だけ：%2。</translation>
    </message>
    <message>
        <source>All curves are shown.</source>
        <translation>すべての曲線を表示しています。</translation>
    </message>
    <message>
        <source>Branch %1 of %2: %3</source>
        <translation>%2本中%1本目：%3</translation>
    </message>
    <message numerus="yes">
        <source>%n branches</source>
        <translation>
            <numerusform>曲線%n本</numerusform>
        </translation>
    </message>
    <message>
        <source>Speed %1 of %2</source>
        <translation>速さ：%2段階中%1</translation>
    </message>
    <message>
        <source>There is no curve to follow here.</source>
        <translation>ここにはたどる曲線がありません。</translation>
    </message>
    <message>
        <source>There are no points of interest in this range.</source>
        <translation>この範囲に注目点はありません。</translation>
    </message>
    <message>
        <source>First move to a point on a curve with the arrow keys.</source>
        <translation>まず矢印キーで曲線上の場所へ移ってください。</translation>
    </message>
    <message>
        <source>The curve has no slope here.</source>
        <translation>ここには傾きがありません。</translation>
    </message>
    <message>
        <source>There are no markers yet. B: add one.</source>
        <translation>目印はまだありません。B で置けます。</translation>
    </message>
    <message>
        <source>There is only one curve.</source>
        <translation>曲線は1本だけです。</translation>
    </message>
    <message>
        <source>The range cannot be changed any further.</source>
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
    <message>
        <source>Spoken form: verbose</source>
        <translation>式の読み上げ：くわしく</translation>
    </message>
    <message>
        <source>Spoken form: brief</source>
        <translation>式の読み上げ：短く</translation>
    </message>
    <message>
        <source>Spoken form: superbrief</source>
        <translation>式の読み上げ：ごく短く</translation>
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
        <source>it does not exist</source>
        <translation>存在しません</translation>
    </message>
    <message>
        <source>it was stopped</source>
        <translation>中止されました</translation>
    </message>
    <message>
        <source>another program is using it</source>
        <translation>ほかのプログラムが使用中です</translation>
    </message>
    <message>
        <source>the file format is not valid</source>
        <translation>ファイルの形式が正しくありません</translation>
    </message>
    <message>
        <source>it is a different kind of file than expected</source>
        <translation>想定と違う種類のファイルです</translation>
    </message>
    <message>
        <source>the graphics driver or the device reported an error</source>
        <translation>グラフィックスドライバーまたはデバイスでエラーが起きました</translation>
    </message>
    <message>
        <source>No sound: no working sound card was found (%1). Connect or switch on speakers or headphones. Everything else works.</source>
        <translation>音が出ません：使えるサウンドカードがありません（%1）。スピーカーかヘッドホンを接続するか、電源を入れてください。ほかの機能は使えます。</translation>
    </message>
    <message>
        <source>No sound: no working sound card was found. Connect or switch on speakers or headphones. Everything else works.</source>
        <translation>音が出ません：使えるサウンドカードがありません。スピーカーかヘッドホンを接続するか、電源を入れてください。ほかの機能は使えます。</translation>
    </message>
    <message>
        <source>%1 (%2)</source>
        <translation>%1（%2）</translation>
    </message>
</context>
</TS>
