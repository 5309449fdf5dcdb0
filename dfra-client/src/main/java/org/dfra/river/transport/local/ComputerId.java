package org.dfra.river.transport.local;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.nio.file.Files;
import java.nio.file.Path;

/**
 * Identifies this computer as the network sees it: the kernel's boot ID and the network namespace.
 * Two containers or simulated robots on one computer differ in the latter. Empty where this Java or
 * the operating system does not provide what local sockets need.
 */
public final class ComputerId {

  private static final System.Logger LOG = System.getLogger(ComputerId.class.getName());

  /** This computer's; empty if local sockets are not used. */
  public static final String OWN = read();

  private ComputerId() {}

  private static String read() {
    if (ModuleLayer.boot().findModule("jdk.net").isEmpty()) { // a runtime made by jlink
      LOG.log(Level.DEBUG, "This Java has no module jdk.net; local calls use TCP.");
      return "";
    }
    try {
      String boot = Files.readString(Path.of("/proc/sys/kernel/random/boot_id")).trim();
      String namespace = Files.readSymbolicLink(Path.of("/proc/self/ns/net")).toString();
      return boot + namespace.replaceAll("[^0-9]+", "/").replaceAll("/$", "");
    } catch (IOException e) {
      LOG.log(Level.DEBUG, "This computer has no boot ID; local calls use TCP.", e);
      return "";
    }
  }
}
