package org.dfra.bringup;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.dfra.core.config.RobotXml;
import org.dfra.core.host.FreePorts;
import org.dfra.directory.ModuleQuery;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.module.Parameter;
import org.dfra.river.bootstrap.RobotBootstrap;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.robot.RunningPhoenix;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A robot whose XML and properties were written before their names changed. */
class RenamedRobotIT {

  private static final String HOST = "127.0.0.1";
  private static final Duration PATIENCE = Duration.ofSeconds(20);

  @TempDir Path folder;

  @Test
  void comesUpAndItsParametersHaveTheNewNames() throws Exception {
    int port = FreePorts.allocate();
    Files.writeString(
        folder.resolve("gps.properties"),
        """
        server=org.dfra.river.server.sensor.GPSServer
        proxy=org.dfra.river.proxy.sensor.GPSProxy
        driver=org.dfra.drivers.gps.m12.M12PlusImpl
        parameter.link=tcp://127.0.0.1:1
        parameter.idle_rate=30
        """);
    Path xml =
        Files.writeString(
            folder.resolve("kappa.xml"),
            """
            <robot xmlns="urn:dfra:robot:1" name="kappa" host="127.0.0.1">
              <group name="all">
                <registrar port="%d" classes="off"/>
                <module name="gps" properties="gps.properties">
                  <parameter name="rate" value="3"/>
                </module>
              </group>
            </robot>
            """
                .formatted(port));
    try (RunningPhoenix phoenix = RunningPhoenix.start(HOST, folder.resolve("phoenix"))) {
      try {
        new RobotBootstrap(phoenix.process(), RobotXml.read(xml)).up();
      } finally {
        phoenix.note();
      }
      try (JiniModuleDirectory finder =
          new JiniModuleDirectory(HOST, List.of(), List.of("jini://" + HOST + ":" + port))) {
        GPSSensor gps =
            finder.findFirst(ModuleQuery.of(GPSSensor.class), PATIENCE).orElseThrow().module();
        assertThat(parameters(gps))
            .containsEntry("period", "3")
            .containsEntry("idle_period", "30")
            .doesNotContainKeys("rate", "idle_rate");
        gps.setParameter("rate", "5");
        assertThat(parameters(gps)).containsEntry("period", "5");
        phoenix.kill("kappa.all");
        await()
            .atMost(PATIENCE)
            .ignoreExceptionsInstanceOf(RemoteException.class)
            .untilAsserted(() -> assertThat(parameters(gps)).containsEntry("period", "3"));
      }
    }
  }

  private static Map<String, String> parameters(GPSSensor gps) throws RemoteException {
    return gps.parameters().stream().collect(Collectors.toMap(Parameter::name, Parameter::value));
  }
}
