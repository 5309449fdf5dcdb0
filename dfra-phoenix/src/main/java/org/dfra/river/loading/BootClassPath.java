package org.dfra.river.loading;

/**
 * Checks that this virtual machine has {@code java.rmi.activation}, which the JDK dropped in
 * version 17 and which proxies of robots need. Only the boot class loader may define it.
 */
public final class BootClassPath {

  private static final String PROBE = "java.rmi.activation.ActivationID";
  private static final String MEND =
      "; start Java with -Xbootclasspath/a:FOLDER/dfra-activation.jar, which is in boot/ beside"
          + " lib/ of a build and in lib/boot/ of an installation";

  private BootClassPath() {}

  /**
   * Does nothing if it is present.
   *
   * @throws IllegalStateException in one sentence, with the option that is missing
   */
  public static void require() {
    try {
      Class<?> unused = Class.forName(PROBE, false, ClassLoader.getSystemClassLoader());
    } catch (ClassNotFoundException e) {
      throw new IllegalStateException("this Java has no java.rmi.activation" + MEND, e);
    } catch (SecurityException e) { // only the boot loader may define classes of java.*
      throw new IllegalStateException(
          "java.rmi.activation is on the class path, not on the boot class path" + MEND, e);
    }
  }
}
