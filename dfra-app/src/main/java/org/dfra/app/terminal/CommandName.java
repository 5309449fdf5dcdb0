package org.dfra.app.terminal;

import java.io.PrintWriter;

/**
 * As what the command line was called: {@code ./dfra} in a checkout, {@code dfra} where it is
 * installed. Every text is written for the checkout.
 */
public final class CommandName {

  /** System property that the launcher sets. */
  private static final String PROPERTY = "dfra.called";

  private static final String IN_CHECKOUT = "./dfra";

  private CommandName() {}

  /** Whether this is no checkout but what was installed from one. */
  public static boolean isInstalled() {
    return !name().equals(IN_CHECKOUT);
  }

  /** Writes hints on what to type as they are typed here. */
  public static PrintWriter replacingName(PrintWriter plain) {
    return isInstalled() ? new Renaming(plain, name()) : plain;
  }

  private static String name() {
    return System.getProperty(PROPERTY, IN_CHECKOUT);
  }

  /** A text that is written at once is renamed as a whole. */
  static final class Renaming extends PrintWriter {

    private final String name;

    Renaming(PrintWriter plain, String name) {
      super(plain, true);
      this.name = name;
    }

    @Override
    public void write(String text, int offset, int length) {
      String renamed =
          text.substring(offset, offset + length).replace(IN_CHECKOUT + " ", name + " ");
      super.write(renamed, 0, renamed.length());
    }
  }
}
