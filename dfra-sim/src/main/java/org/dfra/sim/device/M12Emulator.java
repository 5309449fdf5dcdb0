package org.dfra.sim.device;

import java.time.InstantSource;

/**
 * A Motorola Oncore M12+ behind a TCP port of the loopback interface, as one on a serial server.
 */
public final class M12Emulator extends DeviceEmulator {

  /**
   * @param settings port, speed, path
   * @param clock the time it tells and paces its bytes by; may run at any speed or be stepped
   */
  public M12Emulator(M12EmulatorSettings settings, InstantSource clock) {
    super(
        "m12",
        settings.port(),
        new M12Device(
            settings.path(), settings.baud(), settings.timeToFirstFix(), settings.options()),
        clock);
  }
}
