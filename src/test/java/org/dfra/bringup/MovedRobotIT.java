package org.dfra.bringup;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.List;
import java.util.UUID;
import org.dfra.core.config.RobotXml;
import org.dfra.core.host.FreePorts;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.example.thermometer.SteadyThermometerImpl;
import org.dfra.example.thermometer.Thermometer;
import org.dfra.example.thermometer.ThermometerProxy;
import org.dfra.example.thermometer.ThermometerServer;
import org.dfra.river.bootstrap.RobotBootstrap;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.robot.RunningPhoenix;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * A robot that is switched on with another address than it had before, as DHCP gives them. The
 * short form kills its process at the new address only.
 */
class MovedRobotIT {

  private static final boolean FULL = Boolean.getBoolean("dfra.full");
  private static final Duration PATIENCE = Duration.ofSeconds(20);

  @TempDir Path folder;

  @Test
  void comesUpAtItsNewAddressWithItsOldIdentities() throws Exception {
    assumeTrue(isAddressHere("127.0.0.2"), "127.0.0.2 is no address of this machine");
    int port = FreePorts.allocate();
    UUID before = upAndFound("127.0.0.1", port, FULL);
    assertThat(upAndFound("127.0.0.2", port, true)).isEqualTo(before);
  }

  /**
   * Identity of the robot's thermometer, as the robot's registrar lists it.
   *
   * @param isKilled whether the robot's process is killed there, and has to come back
   */
  private UUID upAndFound(String host, int port, boolean isKilled) throws Exception {
    try (RunningPhoenix phoenix = RunningPhoenix.start(host, folder.resolve("phoenix"))) {
      try {
        new RobotBootstrap(phoenix.process(), RobotXml.read(robot(host, port))).up();
      } finally {
        phoenix.note();
      }
      String locator = "jini://" + host + ":" + port;
      try (JiniModuleDirectory finder =
          new JiniModuleDirectory(host, List.of(), List.of(locator))) {
        // The registrar remembers the former address until the module has registered again.
        await()
            .atMost(PATIENCE)
            .ignoreExceptionsInstanceOf(RemoteException.class)
            .until(() -> cellar(finder).module().celsius() == 4);
        ModuleListing<Thermometer> cellar = cellar(finder);
        if (isKilled) {
          phoenix.kill("iota.all");
          assertThat(cellar.module().celsius()).as("at %s, after kill -9", host).isEqualTo(4);
        }
        return cellar.id();
      }
    }
  }

  private static ModuleListing<Thermometer> cellar(JiniModuleDirectory finder)
      throws InterruptedException {
    return finder.findFirst(ModuleQuery.of(Thermometer.class), PATIENCE).orElseThrow();
  }

  /**
   * Nothing here is restarted by phoenix on its own: the former address exists on this machine, as
   * it would not on a robot that has moved, so what phoenix knew before would come up there.
   */
  private Path robot(String host, int port) throws IOException {
    return Files.writeString(
        folder.resolve("iota.xml"),
        """
        <robot xmlns="urn:dfra:robot:1" name="iota" host="%s">
          <group name="all">
            <registrar port="%d" restart="false"/>
            <module name="cellar" server="%s" proxy="%s" implementation="%s" restart="false">
              <parameter name="celsius" value="4"/>
            </module>
          </group>
        </robot>
        """
            .formatted(
                host,
                port,
                ThermometerServer.class.getName(),
                ThermometerProxy.class.getName(),
                SteadyThermometerImpl.class.getName()));
  }

  private static boolean isAddressHere(String address) throws IOException {
    try (ServerSocket socket = new ServerSocket(0, 1, InetAddress.getByName(address))) {
      return socket.isBound();
    } catch (java.net.BindException e) {
      return false;
    }
  }
}
