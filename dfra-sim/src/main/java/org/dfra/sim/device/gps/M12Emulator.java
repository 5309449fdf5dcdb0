package org.dfra.sim.device.gps;

import java.time.InstantSource;
import org.dfra.sim.device.DeviceEmulator;

/** Serves an emulated Motorola Oncore M12+ on a TCP port of the loopback interface. */
public final class M12Emulator extends DeviceEmulator {

  /**
   * @param settings port, baud rate, antenna trajectory
   * @param clock gives the time that it reports and by which it paces its bytes; may run at any
   *     speed or be stepped
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
