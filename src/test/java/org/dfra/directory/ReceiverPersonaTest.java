package org.dfra.directory;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.dfra.drivers.gps.m12.M12PlusImpl;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.flow.sensor.LocationSensor;
import org.dfra.geometry.GeoPosition;
import org.dfra.lifecycle.Readiness;
import org.dfra.persona.ChainAttributes;
import org.dfra.persona.GpsReceiverAttributes;
import org.dfra.persona.LocationAttributes;
import org.dfra.persona.ModuleAttributes;
import org.dfra.persona.PoseAttributes;
import org.dfra.persona.SensorAttributes;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.river.proxy.sensor.GPSProxy;
import org.dfra.river.server.sensor.GPSServer;
import org.dfra.sim.device.gps.M12Emulator;
import org.dfra.sim.device.gps.M12EmulatorSettings;
import org.dfra.testing.EmbeddedReggie;
import org.dfra.testing.ServedModule;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;

/** A receiver's entries, from the bytes it sends to what a client asks by. */
class ReceiverPersonaTest {

  private static final GeoPosition PLACE = new GeoPosition(27.9506, -82.4572, 14.5);
  private static final Duration PATIENCE = Duration.ofSeconds(20);

  @RegisterExtension static final EmbeddedReggie REGGIE = new EmbeddedReggie();

  @Test
  void isFoundByWhatItCanDoAndItsEntriesFollowIt() throws Exception {
    ModuleQuery<LocationSensor> query =
        ModuleQuery.of(LocationSensor.class)
            .where(SensorAttributes.class, "maxRate", Condition.atLeast(1))
            .where(GpsReceiverAttributes.class, "fixModes", Condition.contains("3D"))
            .where(GpsReceiverAttributes.class, "channels", Condition.equalTo(12))
            .where(ModuleAttributes.class, "state", Condition.equalTo(Readiness.READY))
            .within(100, PLACE);
    try (M12Emulator receiver =
        new M12Emulator(M12EmulatorSettings.at(PLACE).withBaud(115_200), Instant::now)) {
      receiver.start();
      ServedModule<GPSServer> gps =
          ServedModule.of(GPSServer.class, GPSProxy.class, M12PlusImpl.class)
              .with("link", receiver.url())
              .with("mount_z", "0.8")
              .joining(REGGIE);
      try (GPSServer server = gps.serve();
          JiniModuleDirectory directory = REGGIE.directory()) {
        ModuleListing<LocationSensor> found = directory.findFirst(query, PATIENCE).orElseThrow();
        assertThat(found.locality()).as("%s", server).isEqualTo(Locality.SAME_VM);
        assertThat(found.attributes(PoseAttributes.class).orElseThrow())
            .isEqualTo(new PoseAttributes("robot/module", "robot/base_link", 0, 0, 0.8, 0, 0, 0));
        assertThat(found.attributes(ChainAttributes.class).orElseThrow().outputs())
            .contains("GpsFix");
        assertThat(found.attributes(LocationAttributes.class)).isPresent();
        assertThat(found.attributes(ModuleAttributes.class).orElseThrow().driver())
            .isEqualTo(M12PlusImpl.class.getName());

        receiver.close(); // the link is lost, and with it the state READY
        await().atMost(PATIENCE).until(() -> directory.find(query).isEmpty());
        assertThat(directory.find(ModuleQuery.of(GPSSensor.class)))
            .as("still there, only not ready")
            .singleElement()
            .extracting(listing -> listing.attributes(ModuleAttributes.class).orElseThrow().state())
            .isEqualTo(Readiness.INITIALIZING);
        assertThat(List.of(directory.personas().get(0).robot())).containsExactly("robot");
      }
    }
  }
}
