package org.dfra.secure;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Instant;
import org.dfra.example.thermometer.SteadyThermometerImpl;
import org.dfra.example.thermometer.ThermometerProxy;
import org.dfra.example.thermometer.ThermometerServer;
import org.dfra.geometry.GeoPosition;
import org.dfra.sim.device.gps.M12Emulator;
import org.dfra.sim.device.gps.M12EmulatorSettings;

/** Parts of robots' descriptions. */
final class TeamRobots {

  private TeamRobots() {}

  /** An emulated GPS receiver that runs. To be closed. */
  static M12Emulator receiver() throws IOException {
    M12Emulator emulator =
        new M12Emulator(
            M12EmulatorSettings.at(new GeoPosition(27.98, -82.45, 14)).withBaud(115_200),
            Instant::now);
    emulator.start();
    return emulator;
  }

  static String group(String name, String... content) {
    return "<group name=\"" + name + "\">\n" + String.join("", content) + "</group>\n";
  }

  /** Its port is filled in by {@link SecureTeam#describe}. */
  static String registrar() {
    return "<registrar port=\"%d\" class-server-port=\"off\"/>\n";
  }

  /** The thermometer {@code warmth}. */
  static String thermometer(int celsius) {
    return """
    <module name="warmth" server="%s" proxy="%s" implementation="%s">
      <parameter name="celsius" value="%d"/>
    </module>
    """
        .formatted(
            ThermometerServer.class.getName(),
            ThermometerProxy.class.getName(),
            SteadyThermometerImpl.class.getName(),
            celsius);
  }

  /** The thermometer {@code warmth} of somebody who counts its calls in a file. */
  static String counted(Path calls) {
    return """
    <module name="warmth" server="%s" proxy="%s" implementation="%s">
      <parameter name="calls" value="%s"/>
    </module>
    """
        .formatted(
            ThermometerServer.class.getName(),
            ThermometerProxy.class.getName(),
            CountedThermometerImpl.class.getName(),
            calls);
  }

  /** The drive {@code drive}, of emulated wheels. */
  static String drive(String link) {
    return """
    <module name="drive" properties="%s/config/modules/rflex-drive.properties">
      <parameter name="link" value="%s"/>
    </module>
    """
        .formatted(System.getProperty("dfra.root"), link);
  }

  /** The behaviour {@code route}, without anything that could drive. */
  static String route() {
    return """
    <module name="route" properties="%s/config/modules/follow-waypoints.properties"/>
    """
        .formatted(System.getProperty("dfra.root"));
  }

  /** The GPS receiver {@code gps_front}, emulated. */
  static String gps(String link) {
    return """
    <module name="gps_front" server="org.dfra.river.server.sensor.GPSServer"
        proxy="org.dfra.river.proxy.sensor.GPSProxy"
        implementation="org.dfra.drivers.gps.m12.M12PlusImpl">
      <parameter name="link" value="%s"/>
    </module>
    """
        .formatted(link);
  }
}
