package org.dfra.activation;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;

/** Names of classes in a serialized stream. */
final class ClassNames {

  private ClassNames() {}

  /** Replaces the first occurrence: a length in two bytes, then the name. */
  static byte[] replace(byte[] stream, String name, String by) {
    String text = new String(stream, StandardCharsets.ISO_8859_1);
    int at = text.indexOf(name) - 2;
    if (at < 0) {
      throw new AssertionError(name + " is not in the stream");
    }
    ByteArrayOutputStream out = new ByteArrayOutputStream();
    out.write(stream, 0, at);
    out.write(by.length() >> 8);
    out.write(by.length() & 0xff);
    out.writeBytes(by.getBytes(StandardCharsets.ISO_8859_1));
    int rest = at + 2 + name.length();
    out.write(stream, rest, stream.length - rest);
    return out.toByteArray();
  }
}
