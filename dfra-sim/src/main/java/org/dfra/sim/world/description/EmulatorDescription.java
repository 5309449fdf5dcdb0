package org.dfra.sim.world.description;

import java.util.Optional;

/**
 * Settings of a device's emulator; the world stores them unchanged.
 *
 * @param protocol its protocol, such as {@code m12}
 * @param link its link, such as {@code sim:atrv1/gps_front}
 * @param port TCP port on which it listens
 * @param baud bits per second of its serial line
 */
public record EmulatorDescription(
    Optional<String> protocol,
    Optional<String> link,
    Optional<String> port,
    Optional<String> baud) {

  /** No settings. */
  public static final EmulatorDescription NONE =
      new EmulatorDescription(
          Optional.empty(), Optional.empty(), Optional.empty(), Optional.empty());
}
