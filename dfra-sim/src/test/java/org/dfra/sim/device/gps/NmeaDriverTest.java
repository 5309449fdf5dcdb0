package org.dfra.sim.device.gps;

import java.time.Duration;
import java.util.List;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.gps.GpsReceiverImpl;
import org.dfra.drivers.gps.nmea.NmeaImpl;
import org.dfra.sim.device.SerialDevice;
import org.junit.jupiter.api.parallel.Execution;
import org.junit.jupiter.api.parallel.ExecutionMode;

@Execution(ExecutionMode.CONCURRENT) // devices are waited for
class NmeaDriverTest extends ReceiverDriverContract {

  @Override
  SerialDevice device(AntennaTrajectory path, Duration timeToFirstFix) {
    return new NmeaDevice(path, 115_200, timeToFirstFix);
  }

  @Override
  GpsReceiverImpl<?> driver(ModuleContext context) {
    return new NmeaImpl(context);
  }

  @Override
  double resolution() {
    return 1e-8; // millionths of a minute
  }

  @Override
  List<String> furtherTests() {
    return List.of();
  }
}
