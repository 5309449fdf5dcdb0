package org.dfra.cli.security;

import java.security.SecureRandom;
import java.util.Locale;

/**
 * Passphrases of bundles, which people read to each other and type: five groups of five small
 * letters and digits, such as {@code k7x2m-9qhbt-ws4fe-c3zdn-pv8ra}. The letters l and o, which
 * look like digits, and the digits 0 and 1 do not occur.
 */
public final class OneTimePassphrase {

  private static final String ALPHABET = "abcdefghijkmnpqrstuvwxyz23456789"; // 5 bits each
  private static final int GROUPS = 5;
  private static final int GROUP = 5;

  private OneTimePassphrase() {}

  /** A new passphrase with 125 random bits. */
  public static String create(SecureRandom random) {
    StringBuilder text = new StringBuilder();
    for (int i = 0; i < GROUPS * GROUP; i++) {
      text.append(i > 0 && i % GROUP == 0 ? "-" : "");
      text.append(ALPHABET.charAt(random.nextInt(ALPHABET.length())));
    }
    return text.toString();
  }

  /**
   * What was meant by what was typed: with capitals or small letters, with or without hyphens and
   * blanks.
   */
  public static String normalized(String typed) {
    String plain = typed.replaceAll("[\\s-]", "").toLowerCase(Locale.ROOT);
    return plain.length() == GROUPS * GROUP
        ? plain.replaceAll("(.{" + GROUP + "})(?=.)", "$1-")
        : typed.strip();
  }
}
