package org.dfra.river.contract;

import java.time.InstantSource;
import java.util.Map;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ModuleContext;
import org.dfra.flow.sensor.GPSSensor;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;

/** The implementation alone, without any network. */
class ImplementationContractTest extends ModuleContract {

  private final ScriptedGps gps =
      new ScriptedGps(
          new ModuleContext(
              "atrv1", "gps_front", Parameters.of(PATH, Map.of()), InstantSource.system()));

  @BeforeEach
  void start() {
    gps.start();
  }

  @AfterEach
  void end() {
    gps.close();
  }

  @Override
  GPSSensor module() {
    return gps;
  }

  @Override
  ScriptedGps driver() {
    return gps;
  }
}
