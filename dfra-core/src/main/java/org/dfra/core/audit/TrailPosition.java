package org.dfra.core.audit;

import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;

/**
 * The end of a chain of lines.
 *
 * @param number of the last line; 0 if there is none
 * @param hash SHA-256 of the last line without its end, 64 hexadecimal digits
 */
record TrailPosition(long number, String hash) {

  /** Before the first line. */
  static final TrailPosition START = new TrailPosition(0, "0".repeat(64));

  /** After one more line. */
  TrailPosition after(byte[] line) {
    return new TrailPosition(number + 1, hash(line));
  }

  static String hash(byte[] line) {
    return HexFormat.of().formatHex(sha256().digest(line));
  }

  private static MessageDigest sha256() {
    try {
      return MessageDigest.getInstance("SHA-256");
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every Java has SHA-256", e);
    }
  }
}
