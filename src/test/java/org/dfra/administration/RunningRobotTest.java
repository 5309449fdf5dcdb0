package org.dfra.administration;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import net.jini.core.discovery.LookupLocator;
import net.jini.core.entry.Entry;
import net.jini.lookup.entry.Comment;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.Parameters;
import org.dfra.core.config.RobotXml;
import org.dfra.core.config.SourceLocation;
import org.dfra.core.host.FreePorts;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.example.thermometer.SteadyThermometerImpl;
import org.dfra.example.thermometer.Thermometer;
import org.dfra.example.thermometer.ThermometerProxy;
import org.dfra.example.thermometer.ThermometerServer;
import org.dfra.persona.PersonaAttributes;
import org.dfra.river.bootstrap.PhoenixProcess;
import org.dfra.river.bootstrap.RobotBootstrap;
import org.dfra.river.entry.ModuleEntry;
import org.dfra.river.lookup.JiniModuleDirectory;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.remote.ModuleAdmin;
import org.dfra.testing.EmbeddedReggie;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;

/** Phoenix and one group in processes of their own; the lookup service here. */
class RunningRobotTest {

  private static final Duration PATIENCE = Duration.ofSeconds(60);

  @RegisterExtension final EmbeddedReggie reggie = new EmbeddedReggie();
  @TempDir Path folder;
  private PhoenixProcess phoenix;
  private Process process;

  @AfterEach
  void endPhoenix() throws Exception {
    if (process != null) {
      phoenix.shutdown(PATIENCE);
      process.waitFor();
    }
  }

  private RobotBootstrap robot() throws Exception {
    int port = FreePorts.allocate();
    phoenix = new PhoenixProcess("127.0.0.1", port, -1, folder.resolve("phoenix"));
    process = phoenix.start(PATIENCE);
    Path xml = folder.resolve("robot.xml");
    Files.writeString(
        xml,
        """
        <robot xmlns="urn:dfra:robot:1" name="atrv1" host="127.0.0.1">
          <lookup locators="%s"/>
          <group name="lab">
            <jvm-option>-Xmx64m</jvm-option>
            <module name="first" server="%s" proxy="%s" implementation="%s">
              <parameter name="celsius" value="1"/>
            </module>
          </group>
        </robot>
        """
            .formatted(
                reggie.locator(),
                ThermometerServer.class.getName(),
                ThermometerProxy.class.getName(),
                SteadyThermometerImpl.class.getName()));
    RobotBootstrap robot = new RobotBootstrap(phoenix, RobotXml.read(xml));
    robot.up();
    return robot;
  }

  private static ModuleDescription thermometer(String name, String celsius) {
    return new ModuleDescription(
        "atrv1",
        name,
        ThermometerServer.class.getName(),
        ThermometerProxy.class.getName(),
        SteadyThermometerImpl.class.getName(),
        null,
        true,
        Parameters.of("atrv1/" + name, Map.of("celsius", celsius)),
        SourceLocation.CODE);
  }

  private static ModuleQuery<Thermometer> named(String name) {
    return ModuleQuery.of(Thermometer.class).name(name);
  }

  @Test
  void modulesAreAddedReplacedAndRemovedWhileTheOthersWork() throws Exception {
    RobotBootstrap robot = robot();
    try (JiniModuleDirectory directory =
        new JiniModuleDirectory("127.0.0.1", List.of(), List.of(reggie.locator()))) {
      Thermometer first = directory.findFirst(named("first"), PATIENCE).orElseThrow().module();
      assertThat(first.celsius()).isEqualTo(1);

      robot.add(thermometer("second", "2"), "lab");
      ModuleListing<Thermometer> added =
          directory.findFirst(named("second"), PATIENCE).orElseThrow();
      assertThat(added.module().celsius()).isEqualTo(2);
      assertThat(first.celsius()).isEqualTo(1);

      UUID id = added.id();
      robot.replace(thermometer("second", "3"));
      assertThat(added.module().celsius()).as("by the proxy of before").isEqualTo(3);
      await()
          .atMost(PATIENCE)
          .untilAsserted(
              () ->
                  assertThat(directory.find(named("second")))
                      .singleElement()
                      .matches(listing -> listing.id().equals(id)));
      assertThat(first.celsius()).isEqualTo(1);

      assertThatThrownBy(() -> robot.add(thermometer("second", "4"), "lab"))
          .isInstanceOf(ConfigurationException.class)
          .hasMessage(
              "code: there is a module atrv1/second already, in group lab; replace it, or rename"
                  + " one of the two");
      assertThatThrownBy(() -> robot.add(thermometer("third", "4"), "attic"))
          .hasMessage("code: robot atrv1 has no group attic; it has [lab]");
      assertThatThrownBy(() -> robot.replace(thermometer("third", "4")))
          .hasMessage("there is no module atrv1/third to replace; the robot has [first, second]");

      robot.remove("second");
      await().atMost(PATIENCE).until(() -> directory.find(named("second")).isEmpty());
      assertThatThrownBy(() -> added.module().celsius()).isInstanceOf(Exception.class);
      assertThatThrownBy(() -> robot.remove("second"))
          .hasMessage("there is no module atrv1/second to remove; the robot has [first]");
      assertThat(first.celsius()).isEqualTo(1);

      administer((ModuleAdmin) ((ModuleProxy<?>) first).getAdmin());
    }
  }

  @Test
  void aRobotShowsItsPersonaInItsRegistrarAndChangesIt() throws Exception {
    int port = FreePorts.allocate();
    robot();
    String locator = "jini://127.0.0.1:" + port;
    try (JiniModuleDirectory directory =
        new JiniModuleDirectory("127.0.0.1", List.of(), List.of(locator))) {
      for (String role : List.of("scout", "scout", "carrier")) {
        Path xml = folder.resolve("atrv2.xml");
        Files.writeString(
            xml,
            """
            <robot xmlns="urn:dfra:robot:1" name="atrv2" host="127.0.0.1">
              <persona role="%s"><goal>Map the field.</goal></persona>
              <group name="lookup"><registrar port="%d"/></group>
            </robot>
            """
                .formatted(role, port));
        new RobotBootstrap(phoenix, RobotXml.read(xml)).up();
        await()
            .atMost(PATIENCE)
            .untilAsserted(
                () ->
                    assertThat(directory.personas())
                        .singleElement()
                        .extracting(persona -> persona.attributes().orElseThrow())
                        .isEqualTo(
                            new PersonaAttributes(
                                "atrv2", role, List.of("Map the field."), List.of())));
      }
    }
  }

  /** A module's entries and lookup services, changed while it runs. */
  private void administer(ModuleAdmin admin) throws Exception {
    admin.addLookupAttributes(new Entry[] {new Comment("left of the door")});
    assertThat(admin.getLookupAttributes())
        .contains(new Comment("left of the door"))
        .hasAtLeastOneElementOfType(ModuleEntry.class);
    admin.modifyLookupAttributes(new Entry[] {new Comment()}, new Entry[] {new Comment("right")});
    assertThat(admin.getLookupAttributes())
        .contains(new Comment("right"))
        .doesNotContain(new Comment("left of the door"));
    assertThatThrownBy(() -> admin.addLookupAttributes(new Entry[] {new ModuleEntry()}))
        .isInstanceOf(SecurityException.class)
        .hasMessageContaining("is what the module says of itself");
    assertThat(admin.getLookupGroups()).isEmpty();
    try (EmbeddedReggie other = new EmbeddedReggie().start();
        JiniModuleDirectory there =
            new JiniModuleDirectory("127.0.0.1", List.of(), List.of(other.locator()))) {
      admin.addLookupLocators(new LookupLocator[] {new LookupLocator(other.locator())});
      assertThat(there.findFirst(named("first"), PATIENCE)).isPresent();
      admin.setLookupLocators(new LookupLocator[] {new LookupLocator(reggie.locator())});
      await().atMost(PATIENCE).until(() -> there.find(named("first")).isEmpty());
    }
  }
}
