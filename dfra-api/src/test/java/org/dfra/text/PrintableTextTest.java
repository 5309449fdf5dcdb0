package org.dfra.text;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Locale;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class PrintableTextTest {

  private static String of(int... codePoints) {
    return new String(codePoints, 0, codePoints.length);
  }

  @ParameterizedTest
  @ValueSource(
      ints = {
        0x00,
        0x07,
        0x08,
        0x0b,
        0x0c,
        0x1b,
        0x1f,
        0x7f, // C0 and DEL
        0x80,
        0x85,
        0x90,
        0x9b,
        0x9d,
        0x9f, // C1
        0x061c,
        0x200e,
        0x200f,
        0x202a,
        0x202b,
        0x202c,
        0x202d,
        0x202e, // directions
        0x2066,
        0x2067,
        0x2068,
        0x2069, // isolates
        0x2028,
        0x2029, // separators
        0x00ad,
        0x200b,
        0x200c,
        0x200d,
        0x2060,
        0xfeff, // of no width
        0x034f,
        0x115f,
        0x1160,
        0x17b4,
        0x180e,
        0x2800,
        0x3164,
        0xffa0,
        0xfe0f, // without ink
        0xe000,
        0xf8ff,
        0xffff,
        0xd800,
        0xdfff // private, unassigned, halves
      })
  void whatCannotBeSeenIsShownByItsCode(int c) {
    String code = String.format(Locale.ROOT, "\\u%04x", c);
    assertThat(PrintableText.line("a" + of(c) + "b")).isEqualTo("a" + code + "b");
    assertThat(PrintableText.name(of(c))).isEqualTo(code);
    assertThat(PrintableText.lines("x\n" + of(c) + "\ny")).isEqualTo("x\n" + code + "\ny");
    assertThat(PrintableText.output("x\n\t" + of(c))).isEqualTo("x\n\t" + code);
    assertThat(PrintableText.json("[\n  \"" + of(c) + "\"\n]"))
        .isEqualTo("[\n  \"" + code + "\"\n]");
  }

  @Test
  void aCharacterBeyondTheFirstPlaneIsShownByBothHalves() {
    assertThat(PrintableText.line(of(0xe0001))).isEqualTo("\\udb40\\udc01");
    assertThat(PrintableText.line(of(0xe0100))).isEqualTo("\\udb40\\udd00");
    assertThat(PrintableText.line(of(0x10ffff))).isEqualTo("\\udbff\\udfff");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "",
        "robot/gps_front",
        "2 m/s × 3, 27.950603° N, µs ≤ ½ … → – “quoted” 'so' \"so\" \\ / @ #",
        "über Ängström, Łódź, Δ, я, 東京, مرحبا, שלום, नमस्ते",
        "┌─┬─┐ █▓▒░ ●○◆ ✓✗",
        "🤖 ok",
        "Z\u0301\u0302"
      })
  void honestTextStaysAsItIs(String text) {
    assertThat(PrintableText.line(text)).isEqualTo(text);
    assertThat(PrintableText.name(text)).isEqualTo(text);
    assertThat(PrintableText.lines(text)).isEqualTo(text);
    assertThat(PrintableText.output(text)).isEqualTo(text);
    assertThat(PrintableText.json(text)).isEqualTo(text);
  }

  @Test
  void aLineHasNoEnd() {
    assertThat(PrintableText.line("a\r\n2 stopped\tb\n")).isEqualTo("a\\r\\n2 stopped\\tb\\n");
    assertThat(PrintableText.lines("one\r\ntwo\nthree\r2 stopped"))
        .isEqualTo("one\ntwo\nthree\\r2 stopped");
  }

  @Test
  void theCauseOfARemoteFailureGoesOnInTheSameLine() {
    String remote = "no answer; nested exception is: \n\tjava.io.IOException: no route";
    String line = "no answer; nested exception is: java.io.IOException: no route";
    assertThat(PrintableText.line(remote)).isEqualTo(line);
    assertThat(PrintableText.lines(remote)).isEqualTo(line);
  }

  @Test
  void everyBlankIsAPlainOne() {
    assertThat(PrintableText.line(of('a', 0xa0, 0x2003, 0x3000, 0x202f, 'b'))).isEqualTo("a    b");
  }

  @Test
  void aWordHasNoBlanks() {
    assertThat(PrintableText.word("gps_front")).isEqualTo("gps_front");
    assertThat(PrintableText.word("2 stopped." + of(0xa0, 0x3000) + "ö"))
        .isEqualTo("2\\u0020stopped.\\u00a0\\u3000ö");
    assertThat(PrintableText.word("x".repeat(1_000)))
        .isEqualTo("x".repeat(PrintableText.MAX_WORD_LENGTH) + "…");
  }

  @Test
  void marksDoNotCoverOtherLines() {
    String stacked = "e" + of(0x301).repeat(6);
    assertThat(PrintableText.line(stacked)).isEqualTo("e" + of(0x301).repeat(4) + "\\u0301\\u0301");
  }

  @Test
  void aLengthIsBounded() {
    assertThat(PrintableText.name("x".repeat(PrintableText.MAX_NAME_LENGTH)))
        .hasSize(PrintableText.MAX_NAME_LENGTH);
    assertThat(PrintableText.name("x".repeat(10_000)))
        .isEqualTo("x".repeat(PrintableText.MAX_NAME_LENGTH) + "…");
    assertThat(PrintableText.name(of(0x1b).repeat(10_000)))
        .startsWith("\\u001b")
        .endsWith("\\u001b…")
        .hasSizeLessThanOrEqualTo(PrintableText.MAX_NAME_LENGTH + 1);
    assertThat(PrintableText.line("ö".repeat(1_000_000)))
        .hasSize(PrintableText.MAX_LINE_LENGTH + 1);
    assertThat(PrintableText.name("x" + of(0x1f916).repeat(400)))
        .as("no half of a character")
        .endsWith("🤖…");
  }

  /** Of any text, also of one that was printable already. */
  @Test
  void whatWasMadePrintableStays() {
    Random random = new Random(2004);
    for (int i = 0; i < 2_000; i++) {
      int[] text = random.ints(random.nextInt(700), 0, 0x3100).toArray();
      String safe = PrintableText.name(of(text));
      assertThat(PrintableText.name(safe)).isEqualTo(safe);
      assertThat(safe)
          .doesNotContainPattern("[\\p{Cc}\\p{Cf}\\p{Cs}\\p{Co}\\p{Cn}\\p{Zl}\\p{Zp}]")
          .hasSizeLessThanOrEqualTo(PrintableText.MAX_NAME_LENGTH + 1);
    }
  }
}
