package org.dfra.drivers.link;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Set;

/**
 * Recorded bytes: {@code replay:file?pace=1.0&baud=9600&loop=false}. The file contains the received
 * bytes; they are replayed without gaps at the rate of a serial line of {@code baud}, ten bits per
 * byte, {@code pace} times as fast. Bytes written to the link are discarded.
 *
 * @param url the URL as configured
 * @param file the recording; a relative name is relative to the working directory
 * @param pace how many times as fast as the line; 0 is as fast as possible
 * @param baud bits per second of the line
 * @param loop whether to restart at the end; otherwise the link is lost there
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
