package org.dfra.report.terminal;

import java.io.PrintWriter;
import java.util.Objects;
import org.dfra.core.config.RenamedNames;

/**
 * The name with which the command line was called: {@code ./dfra} in a checkout, {@code dfra} in an
 * installation. All texts are written for the checkout.
 */
public final class CommandName {

  /** System property that the launcher sets. */
  private static final String PROPERTY = "dfra.command";

  private static final String IN_CHECKOUT = "./dfra";

  private CommandName() {}

  /** Whether this is an installation and not a checkout. */
  public static boolean isInstalled() {
    return !name().equals(IN_CHECKOUT);
  }

  /** Replaces command names in printed hints by the actual name. */
  public static PrintWriter replacingName(PrintWriter plain) {
    return isInstalled() ? new Renaming(plain, name()) : plain;
  }

  private static String name() {
    return Objects.requireNonNullElse(
        RenamedNames.property(System.getProperties(), PROPERTY), IN_CHECKOUT);
  }

  /** A text is renamed if it is written in one call. */
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
