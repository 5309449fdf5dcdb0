package org.dfra.activation;

import java.util.Map;
import java.util.WeakHashMap;

/**
 * The ports on which the constructor of {@link java.rmi.activation.ActivationGroup} exports groups
 * by JRMP. The specification of that class has no way to close them: to unexport a group is not
 * enough, since its port would go on to serve the garbage collection of JRMP, to everybody on this
 * computer. Thread-safe.
 */
public final class GroupPorts {

  private static final Map<Object, Runnable> OPEN = new WeakHashMap<>();

  private GroupPorts() {}

  /**
   * Remembers the port of a group. For the constructor only.
   *
   * @param close closes it
   */
  public static void opened(Object group, Runnable close) {
    synchronized (OPEN) {
      OPEN.put(group, close);
    }
  }

  /**
   * Closes the port of a group that is exported by another transport, and was unexported. Does
   * nothing the second time.
   */
  public static void close(Object group) {
    Runnable close;
    synchronized (OPEN) {
      close = OPEN.remove(group);
    }
    if (close != null) {
      close.run();
    }
  }
}
