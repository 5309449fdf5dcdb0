package org.dfra.drivers.link;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;

/**
 * Recorded bytes: {@code replay:file?pace=1.0&baud=9600&loop=false}. The file holds the bytes as
 * they came over the line; they are played back-to-back as a line of {@code baud} would bring them,
 * ten bits to a byte, {@code pace} times as fast. What is written to the link is thrown away.
 *
 * @param url the address as written
 * @param file the recording; a relative name is relative to the working directory
 * @param pace how many times as fast as the line; 0 is as fast as possible
 * @param baud bits per second of the line
 * @param loop whether to begin again at the end; otherwise the device is lost there
 */
public record ReplayAddress(String url, Path file, double pace, int baud, boolean loop)
    implements LinkAddress {

  static ReplayAddress of(LinkUrl parts) {
    parts.allow(Set.of("pace", "baud", "loop"));
    if (parts.target().isBlank()) {
      throw parts.fault("it names no file; write replay:file?pace=1.0");
    }
    Path file;
    try {
      file = Path.of(parts.target());
    } catch (IllegalArgumentException e) {
      throw parts.fault("\"" + parts.target() + "\" cannot be the name of a file");
    }
    return new ReplayAddress(
        parts.url(),
        file,
        parts.number("pace", 1, 0),
        parts.whole("baud", 9600, 50, 4_000_000),
        parts.word("loop", "false", Set.of("true", "false")).equals("true"));
  }

  @Override
  public SerialLink open(Ticker ticker) throws IOException {
    if (!Files.isRegularFile(file)) {
      throw new IOException(
          this + ": there is no file " + file.toAbsolutePath().normalize() + "; name a recording");
    }
    if (Files.size(file) == 0) {
      throw new IOException(this + ": the file is empty; name a recording with bytes in it");
    }
    return new ReplayLink(this, ticker);
  }

  @Override
  public String toString() {
    return url;
  }
}
