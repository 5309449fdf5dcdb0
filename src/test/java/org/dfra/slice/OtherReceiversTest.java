package org.dfra.slice;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.awaitility.Awaitility.await;

import java.time.Duration;
import java.time.Instant;
import java.util.UUID;
import java.util.stream.Stream;
import org.dfra.core.module.ModuleImpl;
import org.dfra.directory.Condition;
import org.dfra.directory.ModuleQuery;
import org.dfra.drivers.gps.gpsd.GpsdImpl;
import org.dfra.drivers.gps.nmea.NmeaImpl;
import org.dfra.drivers.gps.ubx.UbxImpl;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.geometry.GeoPosition;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Parameter;
import org.dfra.persona.GpsReceiverAttributes;
import org.dfra.persona.ModuleAttributes;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.river.proxy.sensor.GPSProxy;
import org.dfra.river.server.sensor.GPSServer;
import org.dfra.sim.device.DeviceEmulator;
import org.dfra.sim.device.SerialDevice;
import org.dfra.sim.device.gps.AntennaTrajectory;
import org.dfra.sim.device.gps.GpsdDevice;
import org.dfra.sim.device.gps.NmeaDevice;
import org.dfra.sim.device.gps.UbxDevice;
import org.dfra.testing.EmbeddedReggie;
import org.dfra.testing.ServedModule;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** A further receiver is one class: the other four of the five are those of the M12+. */
class OtherReceiversTest {

  private static final GeoPosition PLACE = new GeoPosition(27.9506, -82.4572, 14.5);
  private static final AntennaTrajectory PATH = AntennaTrajectory.fixed(PLACE);
  private static final Duration PATIENCE = Duration.ofSeconds(20);

  @RegisterExtension static final EmbeddedReggie REGGIE = new EmbeddedReggie();

  static Stream<Arguments> receivers() {
    return Stream.of(
        Arguments.of(NmeaImpl.class, new NmeaDevice(PATH, 115_200, Duration.ZERO), null),
        Arguments.of(UbxImpl.class, new UbxDevice(PATH, 115_200, Duration.ZERO), "NEO-M8N-0"),
        Arguments.of(
            GpsdImpl.class, new GpsdDevice(PATH, 115_200, Duration.ZERO), "NMEA0183 emulator"));
  }

  @ParameterizedTest(name = "{0}")
  @MethodSource("receivers")
  void isFoundAndServesThroughServerAndProxyOfItsKind(
      Class<? extends ModuleImpl> driver, SerialDevice device, String model) throws Exception {
    try (DeviceEmulator receiver = new DeviceEmulator("gps", 0, device, Instant::now)) {
      receiver.start();
      ServedModule<GPSServer> gps =
          ServedModule.of(GPSServer.class, GPSProxy.class, driver)
              .with("link", receiver.url())
              .joining(REGGIE);
      ModuleQuery<GPSSensor> query =
          ModuleQuery.of(GPSSensor.class)
              .where(GpsReceiverAttributes.class, "fixModes", Condition.contains("3D"))
              .where(ModuleAttributes.class, "driver", Condition.equalTo(driver.getName()))
              .where(ModuleAttributes.class, "state", Condition.equalTo(Readiness.READY))
              .within(100, PLACE);
      try (GPSServer server = gps.serve();
          JiniModuleDirectory directory = REGGIE.directory()) {
        GPSProxy found = (GPSProxy) directory.findFirst(query, PATIENCE).orElseThrow().module();
        GPSProxy elsewhere =
            new GPSProxy(found.server(), UUID.randomUUID(), found.identification()); // by network
        GpsFix fix = elsewhere.fix();
        assertThat(fix.mode()).as("%s", server).isEqualTo(GpsFix.Mode.FIX_3D);
        assertThat(fix.position().latitude()).isCloseTo(PLACE.latitude(), within(1e-7));
        assertThat(fix.position().height()).isCloseTo(PLACE.height(), within(0.011));
        assertThat(elsewhere.time().utc()).isAfterOrEqualTo(fix.utc());
        assertThat(elsewhere.test("positions").passed()).isTrue();
        await()
            .atMost(PATIENCE)
            .until(
                () ->
                    elsewhere.parameters().stream()
                        .filter(parameter -> parameter.name().equals("satellites"))
                        .map(Parameter::value)
                        .anyMatch(text -> text.startsWith("9 in view, 9 tracked, 9 used: G")));
        if (model != null) {
          await()
              .atMost(PATIENCE)
              .until(
                  () ->
                      !directory
                          .find(
                              query.where(
                                  GpsReceiverAttributes.class, "model", Condition.equalTo(model)))
                          .isEmpty());
        }
      }
    }
  }
}
