package org.dfra.river.phoenix.host;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import org.junit.jupiter.api.Test;

/** What a group's process writes to its file can be shown on a terminal. */
class PrintableOutputStreamTest {

  private static final String HONEST = "ö × 27.95° N 東 🤖\n\tat a.B.c(B.java:1)\n";

  private final ByteArrayOutputStream file = new ByteArrayOutputStream();
  private final PrintableOutputStream output = new PrintableOutputStream(file);

  private String written() {
    return file.toString(StandardCharsets.UTF_8);
  }

  @Test
  void aStackTraceOfAHostileExceptionControlsNoTerminal() {
    try (PrintStream out = new PrintStream(output, true, StandardCharsets.UTF_8)) {
      new IllegalStateException("\u001b]52;c;eA==\u0007 \u009b2J \u202e desrever \u0085")
          .printStackTrace(out);
    }
    assertThat(written())
        .startsWith(
            "java.lang.IllegalStateException: \\u001b]52;c;eA==\\u0007 \\u009b2J \\u202e desrever"
                + " \\u0085\n\tat ")
        .doesNotContainPattern("[\\p{Cc}\\p{Cf}&&[^\n\t]]");
  }

  @Test
  void honestTextIsWrittenAsItIsHoweverItComes() throws IOException {
    byte[] bytes = HONEST.getBytes(StandardCharsets.UTF_8);
    output.write(bytes);
    for (byte each : bytes) {
      output.write(each);
    }
    for (int begin = 0; begin < bytes.length; begin += 5) {
      output.write(bytes, begin, Math.min(5, bytes.length - begin));
    }
    output.flush();
    assertThat(written()).isEqualTo(HONEST.repeat(3));
  }

  @Test
  void aControlCharacterThatComesInTwoPiecesIsEscapedToo() throws IOException {
    output.write(0xc2);
    output.write(0x9b);
    output.write("2J".getBytes(StandardCharsets.UTF_8));
    assertThat(written()).isEqualTo("\\u009b2J");
  }

  @Test
  void bytesThatAreNoTextAreReplaced() throws IOException {
    output.write(new byte[] {(byte) 0x9b, '2', 'J'});
    output.write(0xe2);
    output.close();
    assertThat(written()).isEqualTo("\ufffd2J\ufffd");
  }
}
