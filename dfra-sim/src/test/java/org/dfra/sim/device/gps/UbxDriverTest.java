package org.dfra.sim.device.gps;

import java.time.Duration;
import java.util.List;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.gps.GpsReceiverImpl;
import org.dfra.drivers.gps.ubx.UbxImpl;
import org.dfra.sim.device.SerialDevice;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

@Execution(ExecutionMode.CONCURRENT) // devices are waited for
class UbxDriverTest extends ReceiverDriverContract {

  @Override
  SerialDevice device(AntennaTrajectory path, Duration timeToFirstFix) {
    return new UbxDevice(path, 115_200, timeToFirstFix);
  }

  @Override
  GpsReceiverImpl<?> driver(ModuleContext context) {
    return new UbxImpl(context);
  }

  @Override
  double resolution() {
    return 1e-7 / 2 + 1e-12;
  }

  @Override
  List<String> furtherTests() {
    return List.of("identification");
  }
}
