package org.dfra.core.config;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dfra.core.config.RobotDescription.GroupDescription;
import org.junit.jupiter.api.Test;

/** The records validate themselves, whatever creates them. */
class DescriptionsTest {

  private static final SourceLocation PLACE = new SourceLocation("robot.xml", 7);

  private static ModuleDescription module(String name) {
    return new ModuleDescription(
        "atrv1",
        name,
        "a.Server",
        "a.Proxy",
        "a.Driver",
        null,
        true,
        Parameters.of("atrv1/" + name, Map.of("link", "sim:")),
        PLACE);
  }

  private static GroupDescription group(String name, ModuleDescription... modules) {
    return new GroupDescription(name, List.of(), Optional.empty(), List.of(modules), PLACE);
  }

  private static RobotDescription robot(GroupDescription... groups) {
    return new RobotDescription(
        "atrv1", "auto", List.of(), List.of(), List.of(groups), Path.of("robot.xml"));
  }

  @Test
  void aPlaceIsWrittenAsCompilersWriteIt() {
    assertThat(PLACE).hasToString("robot.xml:7");
    assertThat(new SourceLocation("robot.xml", 0)).hasToString("robot.xml");
    assertThatThrownBy(() -> new SourceLocation("robot.xml", -1))
        .hasMessage("line -1 of robot.xml is below 0");
    assertThatThrownBy(() -> new SourceLocation(" ", 1)).hasMessage("a place names no file");
  }

  @Test
  void aModuleIsSmallEnoughForTheActivationLogAndComesBackFromIt() throws Exception {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(module("gps"));
    }

    assertThat(bytes.size()).isLessThan(1200);
    assertThat(read(bytes.toByteArray())).isEqualTo(module("gps"));
  }

  private static Object read(byte[] bytes) throws IOException, ClassNotFoundException {
    try (ObjectInputStream in = new ObjectInputStream(new ByteArrayInputStream(bytes))) {
      return in.readObject();
    }
  }

  @Test
  void aModuleChecksItsNamesAndClasses() {
    assertThatThrownBy(() -> module("Gps"))
        .isInstanceOf(ConfigurationException.class)
        .hasMessage("robot.xml:7: the module name \"Gps\" is not lower_snake_case; write \"gps\"");
    assertThatThrownBy(
            () ->
                new ModuleDescription(
                    "atrv1",
                    "gps",
                    "a.B",
                    "a.",
                    "a.C",
                    null,
                    true,
                    Parameters.of("x", Map.of()),
                    PLACE))
        .hasMessage(
            "robot.xml:7: the proxy of module gps is \"a.\", which is not a class name;"
                + " write the full name of a Java class");
    assertThatThrownBy(
            () ->
                new ModuleDescription(
                    "atrv1", "gps", "B", "C", "D", " ", true, Parameters.of("x", Map.of()), PLACE))
        .hasMessage(
            "robot.xml:7: the configuration of module gps is blank; name a file or leave it out");
  }

  @Test
  void aRegistrarChecksItsPort() {
    assertThatThrownBy(() -> new RegistrarDescription(70000, 8085, true, PLACE))
        .hasMessage(
            "robot.xml:7: the registrar's port is \"70000\"; write a whole number from 0 to 65535");
    assertThatThrownBy(() -> new RegistrarDescription(4160, 70000, true, PLACE))
        .hasMessage(
            "robot.xml:7: the class server's port is \"70000\"; write a whole number from 1 to"
                + " 65535, or off");
    assertThat(new RegistrarDescription(4160, 0, true, PLACE).hasClassServer()).isFalse();
  }

  @Test
  void aGroupCopiesItsListsAndRefusesAnEmptyOption() {
    List<String> options = new ArrayList<>(List.of(" -Xmx64m "));
    GroupDescription group =
        new GroupDescription("gps", options, Optional.empty(), List.of(), PLACE);
    options.clear();

    assertThat(group.jvmOptions()).containsExactly("-Xmx64m");
    assertThatThrownBy(
            () -> new GroupDescription("gps", List.of(" "), Optional.empty(), List.of(), PLACE))
        .hasMessage("robot.xml:7: group gps has an empty JVM option; write one or leave it out");
  }

  @Test
  void aRobotRefusesWhatItsPartsCannotSee() {
    assertThatThrownBy(() -> robot())
        .hasMessage("robot.xml: robot atrv1 has no group; add one, since a group runs its modules");
    assertThatThrownBy(() -> robot(group("a"), group("a")))
        .hasMessage("robot.xml:7: there is a second group a; rename or delete one");
    assertThatThrownBy(() -> robot(group("a", module("gps")), group("b", module("gps"))))
        .hasMessage("robot.xml:7: there is a second module gps; rename or delete one");
    GroupDescription lookup =
        new GroupDescription(
            "lookup",
            List.of(),
            Optional.of(new RegistrarDescription(4160, 8085, true, PLACE)),
            List.of(),
            PLACE);
    GroupDescription other =
        new GroupDescription("other", List.of(), lookup.registrar(), List.of(), PLACE);
    assertThatThrownBy(() -> robot(lookup, other))
        .hasMessage(
            "robot.xml: robot atrv1 has more than one registrar; leave it in one group only");
  }

  @Test
  void aRobotRefusesAnotherRobotsModule() {
    assertThatThrownBy(
            () ->
                new RobotDescription(
                    "atrv2",
                    "auto",
                    List.of(),
                    List.of(),
                    List.of(group("a", module("gps"))),
                    Path.of("robot.xml")))
        .hasMessage("robot.xml:7: module atrv1/gps is not of robot atrv2; give it that robot");
  }

  @Test
  void aRobotChecksWhatItLooksUp() {
    assertThatThrownBy(
            () ->
                new RobotDescription(
                    "a", "auto", List.of("x,y"), List.of(), List.of(group("g")), Path.of("r.xml")))
        .hasMessage("r.xml: the discovery group \"x,y\" is blank or holds a comma; write one name");
    assertThat(
            new RobotDescription(
                    "a", "auto", List.of(), List.of("b:1"), List.of(group("g")), Path.of("r.xml"))
                .locators())
        .containsExactly("jini://b:1");
  }
}
