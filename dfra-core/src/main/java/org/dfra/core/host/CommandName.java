package org.dfra.core.host;

import java.util.List;
import java.util.Objects;
import org.dfra.core.config.RenamedNames;

/**
 * The name of DFRA's command, for hints on what to type: {@code ./dfra} in a checkout, {@code dfra}
 * where it is installed.
 */
public final class CommandName {

  /** System property that the launcher sets. */
  private static final String PROPERTY = "dfra.command";

  private static final String IN_CHECKOUT = "./dfra";

  /** The name in the texts of picocli's annotations, which are constants: a variable of picocli. */
  public static final String IN_HELP = "${sys:" + PROPERTY + ":-" + IN_CHECKOUT + "}";

  private CommandName() {}

  /** The name, to be followed by a blank and a verb. */
  public static String current() {
    return Objects.requireNonNullElse(
        RenamedNames.property(System.getProperties(), PROPERTY), IN_CHECKOUT);
  }

  /** Whether this is an installation and not a checkout. */
  public static boolean isInstalled() {
    return !current().equals(IN_CHECKOUT);
  }

  /** The JVM options with which the hints of another virtual machine have the same name. */
  public static List<String> options() {
    return isInstalled() ? List.of("-D" + PROPERTY + "=" + current()) : List.of();
  }
}
