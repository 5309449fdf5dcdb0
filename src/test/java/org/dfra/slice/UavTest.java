package org.dfra.slice;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.awaitility.Awaitility.await;

import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Map;
import java.util.UUID;
import org.awaitility.core.ConditionFactory;
import org.dfra.core.query.QueryParser;
import org.dfra.core.query.QueryTypeNames;
import org.dfra.directory.ModuleListing;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.CommandRefusedException;
import org.dfra.flow.effector.FlightCommand.Arm;
import org.dfra.flow.effector.FlightCommand.Land;
import org.dfra.flow.effector.FlightCommand.TakeOff;
import org.dfra.flow.effector.FlightState.Phase;
import org.dfra.geometry.GeoPosition;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Module;
import org.dfra.module.NotReadyException;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.proxy.effector.FlightProxy;
import org.dfra.river.proxy.sensor.BatteryProxy;
import org.dfra.river.proxy.sensor.GPSProxy;
import org.dfra.river.server.ModuleServer;
import org.dfra.river.server.effector.FlightServer;
import org.dfra.river.server.sensor.BatteryServer;
import org.dfra.river.server.sensor.GPSServer;
import org.dfra.sim.device.DeviceEmulator;
import org.dfra.sim.device.gps.AntennaTrajectory;
import org.dfra.sim.device.uav.AutopilotDevice;
import org.dfra.sim.device.uav.AutopilotSettings;
import org.dfra.sim.device.uav.AutopilotSettings.AutopilotSoftware;
import org.dfra.sim.physics.BatteryPhysics.Charge;
import org.dfra.sim.physics.MulticopterPhysics;
import org.dfra.testing.EmbeddedReggie;
import org.dfra.testing.ServedModule;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;

/**
 * An unmanned aerial vehicle, from its XML and properties to the proxies that are found by what
 * they can do: three modules on one link.
 */
@Timeout(120)
class UavTest {

  private static final GeoPosition PLACE = new GeoPosition(27.9506, -82.4572, 14.5);
  private static final Duration PATIENCE = Duration.ofSeconds(20);

  @RegisterExtension static final EmbeddedReggie REGGIE = new EmbeddedReggie();

  @TempDir Path folder;

  @Test
  void isFoundByHowHighItFliesAndFliesFromAfar() throws Exception {
    AutopilotDevice autopilot =
        new AutopilotDevice(
            AutopilotSettings.of(AutopilotSoftware.PX4),
            PLACE,
            new Lift(),
            AntennaTrajectory.fixed(PLACE),
            time -> new Charge(15.8, 4.2, 0.87));
    try (DeviceEmulator vehicle =
        new DeviceEmulator("autopilot", 0, autopilot, InstantSource.system())) {
      vehicle.start();
      Map<String, String> link = Map.of("link", vehicle.url());
      Map<String, String> low = Map.of("link", vehicle.url(), "max_height", "60");
      try (FlightServer flight = serve(FlightServer.class, FlightProxy.class, "flight", low);
          GPSServer gps = serve(GPSServer.class, GPSProxy.class, "gps", link);
          BatteryServer battery = serve(BatteryServer.class, BatteryProxy.class, "battery", link);
          JiniModuleDirectory directory = REGGIE.directory()) {
        ModuleListing<?> listing =
            find(
                directory,
                "FlightEffector with flight.maxHeight >= 50 and flight.vehicleType = quadrotor"
                    + " and effector.commands contains TakeOff and module.state = READY");
        assertThat(listing.attributes()).asString().contains("maxHeight=60.0", "autopilot=PX4");
        FlightProxy found = (FlightProxy) listing.module();
        FlightProxy elsewhere =
            new FlightProxy(found.server(), UUID.randomUUID(), found.identification());
        fly(elsewhere, found);

        GPSProxy fixes = (GPSProxy) find(directory, "GPSSensor with module.state = READY").module();
        GPSProxy remote = new GPSProxy(fixes.server(), UUID.randomUUID(), fixes.identification());
        assertThat(remote.fix().position().height()).as("%s", gps).isCloseTo(14.5, within(0.002));
        BatteryProxy cells =
            (BatteryProxy) find(directory, "BatterySensor with module.state = READY").module();
        BatteryProxy afar =
            new BatteryProxy(cells.server(), UUID.randomUUID(), cells.identification());
        assertThat(afar.battery().remaining()).as("%s", battery).isCloseTo(0.87, within(1e-3));
        assertThat(elsewhere.readiness()).as("%s", flight).isEqualTo(Readiness.READY);
      }
    }
  }

  private static void fly(FlightProxy far, FlightProxy near) throws Exception {
    patiently().until(() -> far.flightState().position() != null);
    CommandLease lease = far.acquireCommandLease(Duration.ofSeconds(10));
    far.execute(lease.key(), new Arm());
    patiently().until(() -> near.flightState().isArmed());
    far.execute(lease.key(), new TakeOff(2));
    patiently().until(() -> far.flightState().phase() == Phase.IN_AIR);
    patiently().until(() -> near.flightState().height() > 1.99);
    patiently().until(() -> far.flightState().height() > 1.99);
    assertThat(far.flightState().position().height()).isCloseTo(16.5, within(0.02));
    assertThatThrownBy(() -> far.execute(lease.key(), new TakeOff(2)))
        .isInstanceOf(IllegalArgumentException.class)
        .hasMessageContaining("flies already");
    far.execute(lease.key(), new Land());
    lease.close();
    assertThatThrownBy(() -> far.execute(lease.key(), new Arm()))
        .isInstanceOf(CommandRefusedException.class);
    patiently()
        .until(() -> far.flightState().phase() == Phase.ON_GROUND && !near.flightState().isArmed());
  }

  private static ConditionFactory patiently() {
    return await()
        .atMost(Duration.ofSeconds(40))
        .ignoreExceptionsInstanceOf(NotReadyException.class); // old for a moment
  }

  private static ModuleListing<?> find(JiniModuleDirectory directory, String query)
      throws Exception {
    return directory
        .findFirst(new QueryParser(QueryTypeNames.standard()).parse(query), PATIENCE)
        .orElseThrow(() -> new AssertionError("nothing found for: " + query));
  }

  /** As a robot's XML and the properties that come with DFRA describe it, on this link. */
  private <S extends ModuleServer<?>> S serve(
      Class<S> server,
      Class<? extends ModuleProxy<? extends Module>> proxy,
      String name,
      Map<String, String> parameters)
      throws Exception {
    return ServedModule.fromProperties(server, proxy, folder, name, "mavlink-" + name, parameters)
        .joining(REGGIE)
        .serve();
  }

  /** A body that goes up and down at 2 m/s, and nowhere else. */
  private static final class Lift implements MulticopterPhysics {

    private double up;
    private double goal;
    private boolean rotors;
    private Instant last = Instant.MAX;

    @Override
    public void rotors(Instant time, boolean turn) {
      rotors = turn;
    }

    @Override
    public void fly(Instant time, double east, double north, double toUp, double speed) {
      goal = toUp;
    }

    @Override
    public MulticopterState at(Instant time) {
      if (time.isAfter(last)) {
        double most = 2 * Duration.between(last, time).toNanos() / 1e9;
        up += Math.max(-most, Math.min(most, goal - up));
      }
      last = time;
      return new MulticopterState(0, 0, up, 0, 0, 0, Math.signum(goal - up) * 2, rotors);
    }
  }
}
