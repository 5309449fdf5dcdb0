package org.dfra.core.host;

import java.io.IOException;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HexFormat;
import java.util.List;
import java.util.stream.Stream;

/**
 * A TCP socket of this computer that listens, from Linux's {@code /proc/net/tcp}. See
 * proc_net_tcp(5).
 *
 * @param address where it listens; may be the wildcard address
 * @param port its port
 * @param uid the user whose process opened it
 * @param inode its inode
 */
public record ListeningSocket(InetAddress address, int port, int uid, String inode) {

  private static final String LISTEN = "0A";
  private static final int LOCAL = 1;
  private static final int STATE = 3;
  private static final int UID = 7;
  private static final int INODE = 9;
  private static final int WORD = 4;

  /**
   * All of them; none on another system than Linux.
   *
   * @param proc the folder {@code /proc}
   */
  public static List<ListeningSocket> all(Path proc) {
    return Stream.of("net/tcp", "net/tcp6")
        .flatMap(table -> lines(proc.resolve(table)))
        .map(line -> line.strip().split("\\s+"))
        .filter(fields -> fields.length > INODE && fields[STATE].equals(LISTEN))
        .map(ListeningSocket::of)
        .toList();
  }

  private static Stream<String> lines(Path table) {
    try {
      return Files.readAllLines(table, StandardCharsets.US_ASCII).stream().skip(1); // headings
    } catch (IOException e) {
      return Stream.of(); // a computer without IPv6 has one table, and one without Linux has none
    }
  }

  private static ListeningSocket of(String[] fields) {
    String local = fields[LOCAL];
    int colon = local.lastIndexOf(':');
    try {
      return new ListeningSocket(
          InetAddress.getByAddress(bytes(local.substring(0, colon))),
          Integer.parseInt(local.substring(colon + 1), 16),
          Integer.parseInt(fields[UID]),
          fields[INODE]);
    } catch (UnknownHostException e) {
      throw new IllegalStateException("4 or 16 bytes are an address, and not " + local, e);
    }
  }

  /** An address is written as words of four bytes, the least significant byte last. */
  private static byte[] bytes(String hexadecimal) {
    byte[] written = HexFormat.of().parseHex(hexadecimal);
    byte[] address = new byte[written.length];
    for (int i = 0; i < written.length; i++) {
      int inWord = i % WORD;
      address[i] = written[i - inWord + WORD - 1 - inWord];
    }
    return address;
  }
}
