package org.dfra.river.filter;

/**
 * Marks a class loader whose classes passed the trust check: a peer that may run code here may also
 * send data of that code's classes.
 */
public interface TrustedLoader {

  /**
   * Whether its own code has a file, regardless of its parent.
   *
   * @param file as in {@code org/example/Sensor.class}
   */
  boolean hasFile(String file);
}
