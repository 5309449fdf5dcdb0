package org.dfra.sim.device.gps;

import java.time.Duration;
import java.util.List;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.gps.GpsReceiverImpl;
import org.dfra.drivers.gps.m12.M12PlusImpl;
import org.dfra.sim.device.SerialDevice;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

/** What the M12+ has in common with all receivers; what is its own is in M12DriverTest. */
@Execution(ExecutionMode.CONCURRENT) // devices are waited for
class M12ReceiverDriverTest extends ReceiverDriverContract {

  @Override
  SerialDevice device(AntennaTrajectory path, Duration timeToFirstFix) {
    return new M12Device(path, 115_200, timeToFirstFix);
  }

  @Override
  GpsReceiverImpl<?> driver(ModuleContext context) {
    return new M12PlusImpl(context);
  }

  @Override
  double resolution() {
    return 1.4e-7; // half a milli-arc-second
  }

  @Override
  List<String> furtherTests() {
    return List.of("identification", "antenna", "integrity");
  }
}
