package org.dfra.cli.robot;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import org.dfra.core.config.RobotDescription;
import org.dfra.core.config.RobotXml;
import org.dfra.directory.ModuleQuery;
import org.dfra.example.thermometer.SteadyThermometerImpl;
import org.dfra.example.thermometer.Thermometer;
import org.dfra.example.thermometer.ThermometerProxy;
import org.dfra.example.thermometer.ThermometerServer;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.testing.EmbeddedReggie;
import org.dfra.testing.ServedModule;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;

/** What {@code ./dfra up} finds of a robot that has the name of the one it brings up. */
class DuplicateRobotSearchTest {

  private static final Duration PATIENCE = Duration.ofSeconds(60);

  @RegisterExtension static final EmbeddedReggie REGGIE = new EmbeddedReggie();

  @Test
  void warnsOfANamesakeOnTheSameHostAndNotOfTheRobotsOwnModules(@TempDir Path folder)
      throws Exception {
    RobotDescription robot =
        RobotXml.read(
            Files.writeString(
                folder.resolve("robot.xml"),
                """
                <robot xmlns="urn:dfra:robot:1" name="robot" host="%s">
                  <lookup locators="%s"/>
                  <group name="one"/>
                </robot>
                """
                    .formatted(EmbeddedReggie.HOST, REGGIE.locator().replace("jini://", ""))));
    ServedModule<ThermometerServer> other =
        ServedModule.of(
                ThermometerServer.class, ThermometerProxy.class, SteadyThermometerImpl.class)
            .joining(REGGIE);
    UUID id = other.activation().id();
    try (JiniModuleDirectory all = REGGIE.directory();
        ThermometerServer serving = other.serve()) {
      assertThat(serving).isNotNull();
      assertThat(all.findFirst(ModuleQuery.of(Thermometer.class), PATIENCE)).isPresent();
      assertThat(warning(robot, Set.of()))
          .contains(
              "ANOTHER ROBOT IS NAMED robot, on this host under another phoenix, and this one on "
                  + EmbeddedReggie.HOST
                  + "; a call to robot may reach either: take one of them down and give it"
                  + " another name in its XML");
      assertThat(warning(robot, Set.of(id))).as("its own").isEmpty();
    }
  }

  private static Optional<String> warning(RobotDescription robot, Set<UUID> own) throws Exception {
    try (DuplicateNameSearch search = DuplicateNameSearch.begin(robot)) {
      return search.warning(own);
    }
  }
}
