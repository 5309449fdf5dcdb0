package org.dfra.river.phoenix.host;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import org.dfra.text.PrintableText;

/**
 * Writes UTF-8 text and escapes everything that is not {@linkplain PrintableText#output printable},
 * so that a terminal can show the file safely.
 */
public final class PrintableOutputStream extends OutputStream {

  private static final int LONGEST_CHARACTER = 4;

  private final OutputStream out;

  // the first bytes of an incomplete character
  @GuardedBy("this")
  private byte[] begun = {};

  public PrintableOutputStream(OutputStream out) {
    this.out = out;
  }

  @Override
  public synchronized void write(int b) throws IOException {
    write(new byte[] {(byte) b}, 0, 1);
  }

  @Override
  public synchronized void write(byte[] bytes, int offset, int length) throws IOException {
    byte[] all = Arrays.copyOf(begun, begun.length + length);
    System.arraycopy(bytes, offset, all, begun.length, length);
    int end = endOfCharacters(all);
    begun = Arrays.copyOfRange(all, end, all.length);
    if (end > 0) {
      String text = new String(all, 0, end, StandardCharsets.UTF_8);
      out.write(PrintableText.output(text).getBytes(StandardCharsets.UTF_8));
    }
  }

  /** The start of the last character if it is incomplete, else the length. */
  private static int endOfCharacters(byte[] bytes) {
    for (int i = bytes.length - 1; i >= 0 && i > bytes.length - LONGEST_CHARACTER; i--) {
      int first = bytes[i] & 0xff;
      if (first >= 0xc0) {
        int length = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
        return i + length > bytes.length ? i : bytes.length;
      } else if (first < 0x80) {
        return bytes.length;
      }
    }
    return bytes.length;
  }

  @Override
  public synchronized void flush() throws IOException {
    out.flush();
  }

  @Override
  public synchronized void close() throws IOException {
    if (begun.length > 0) {
      out.write(
          new String(begun, StandardCharsets.UTF_8).getBytes(StandardCharsets.UTF_8)); // U+FFFD
    }
    out.close();
  }
}
