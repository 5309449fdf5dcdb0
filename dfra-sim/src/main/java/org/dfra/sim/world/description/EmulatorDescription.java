package org.dfra.sim.world.description;

import java.util.Optional;

/**
 * What is written for the emulator of a device; the world keeps it as it is.
 *
 * @param protocol what it speaks, such as {@code m12}
 * @param link over which it is reached, such as {@code sim:atrv1/gps_front}
 * @param port at which it listens
 * @param baud bits per second of its line
 */
public record EmulatorDescription(
    Optional<String> protocol,
    Optional<String> link,
    Optional<String> port,
    Optional<String> baud) {

  /** Nothing is written. */
  public static final EmulatorDescription NONE =
      new EmulatorDescription(
          Optional.empty(), Optional.empty(), Optional.empty(), Optional.empty());
}
