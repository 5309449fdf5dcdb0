package org.dfra.cli.team;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.lang.reflect.Proxy;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.UUID;
import org.dfra.directory.Locality;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.Persona;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Module;
import org.dfra.persona.ModuleAttributes;
import org.dfra.report.terminal.CommandFailure;
import org.junit.jupiter.api.Test;

/** Robots of one name are distinguished, and none of them is chosen by chance. */
class DuplicateRobotNamesTest {

  private static final Module MODULE =
      (Module)
          Proxy.newProxyInstance(
              DuplicateRobotNamesTest.class.getClassLoader(),
              new Class<?>[] {Module.class},
              (proxy, method, arguments) -> {
                throw new AssertionError("nobody is to be asked: " + method);
              });

  private static final ModuleListing<Module> FIRST = drive(1, "10.0.0.5", false);
  private static final ModuleListing<Module> SECOND = drive(2, "10.0.0.6", false);

  private static ModuleListing<Module> drive(int id, String host, boolean stale) {
    return listing(id, "r", "drive", host, stale);
  }

  private static ModuleListing<Module> listing(
      int id, String robot, String name, String host, boolean stale) {
    return new ModuleListing<>(
        new UUID((long) id << 32, id),
        MODULE,
        robot,
        name,
        List.of(
            new ModuleAttributes(
                robot, name, "D", host, "me", "1", Readiness.READY, Instant.EPOCH, null, 0)),
        Locality.REMOTE,
        stale,
        Instant.EPOCH);
  }

  @Test
  void robotsOfOneNameOnTwoHostsAreFound() {
    assertThat(
            DuplicateRobotNames.of(
                List.of(FIRST, SECOND, listing(3, "s", "drive", "10.0.0.6", false))))
        .isEqualTo(Map.of("r", List.of("10.0.0.5", "10.0.0.6")));
    assertThat(DuplicateRobotNames.of(List.of(FIRST, listing(2, "r", "gps", "10.0.0.5", false))))
        .isEmpty();
    assertThat(DuplicateRobotNames.of(List.of(FIRST, drive(2, "10.0.0.6", true))))
        .as("it may be gone")
        .isEmpty();
  }

  @Test
  void twoOnOneHostAreFoundByTheirModules() {
    assertThat(DuplicateRobotNames.of(List.of(FIRST, drive(2, "10.0.0.5", false))))
        .isEqualTo(Map.of("r", List.of("10.0.0.5", "10.0.0.5")));
    assertThat(DuplicateRobotNames.inWords("r", List.of("10.0.0.5", "10.0.0.6")))
        .isEqualTo("2 robots are named r, on 10.0.0.5 and 10.0.0.6");
  }

  @Test
  void aModuleThatTwoRobotsHaveIsRefusedWithTheNamesThatDistinguishThem() {
    assertThatThrownBy(() -> ModuleName.of("r/drive").choose(List.of(FIRST, SECOND)))
        .isInstanceOf(CommandFailure.class)
        .hasMessage(
            "there are several modules r/drive; name one of r@10.0.0.5/drive, r@10.0.0.6/drive");
    assertThatThrownBy(
            () -> ModuleName.of("r/drive").choose(List.of(FIRST, drive(2, "10.0.0.5", false))))
        .hasMessage(
            "there are several modules r/drive; name one of r@00000001/drive, r@00000002/drive");
    assertThatThrownBy(
            () ->
                ModuleName.of("drive")
                    .choose(List.of(FIRST, listing(3, "s", "drive", "10.0.0.5", false))))
        .hasMessage("there are several modules drive; name one of r/drive, s/drive");
  }

  @Test
  void theNamesThatDistinguishThemAreUnderstood() {
    List<ModuleListing<Module>> both = List.of(FIRST, SECOND);
    assertThat(ModuleName.of("r@10.0.0.6/drive").choose(both)).isEqualTo(SECOND);
    assertThat(ModuleName.of("r@00000001/drive").choose(both)).isEqualTo(FIRST);
    assertThat(ModuleName.of("r@0/drive").at(both)).as("too short to be sure").isEmpty();
    assertThat(ModuleName.of("r/drive").choose(List.of(FIRST, drive(2, "10.0.0.6", true))))
        .as("the other may be gone")
        .isEqualTo(FIRST);
  }

  private static Persona persona(String robot, String host, boolean stale) {
    return new Persona(robot, host, Optional.empty(), List.of(), stale, Instant.EPOCH);
  }

  @Test
  void aPersonaIsChosenByNameAndHost() {
    Persona first = persona("r", "10.0.0.5", false);
    Persona second = persona("r", "10.0.0.6", false);
    List<Persona> team = List.of(first, second, persona("s", "10.0.0.6", false));
    assertThatThrownBy(() -> DuplicateRobotNames.choose("r", team))
        .isInstanceOf(CommandFailure.class)
        .hasMessage(
            "2 robots are named r, on 10.0.0.5 and 10.0.0.6; name one of r@10.0.0.5, r@10.0.0.6");
    assertThat(DuplicateRobotNames.choose("r@10.0.0.6", team)).contains(second);
    assertThat(DuplicateRobotNames.choose("t", team)).isEmpty();
    assertThat(DuplicateRobotNames.choose("r", List.of(persona("r", "10.0.0.6", true), first)))
        .as("the other may be gone")
        .contains(first);
  }

  @Test
  void listingsDistinguishThemByHost() {
    ModuleListing<Module> other = listing(3, "s", "drive", "10.0.0.6", false);
    List<ModuleListing<Module>> all = List.of(FIRST, SECOND, other);
    assertThat(all.stream().map(each -> DuplicateRobotNames.displayName(each, all)))
        .containsExactly("r@10.0.0.5", "r@10.0.0.6", "s");
    assertThat(DuplicateRobotNames.displayPath(SECOND, all)).isEqualTo("r@10.0.0.6/drive");
    assertThat(DuplicateRobotNames.displayPath(FIRST, List.of(FIRST, other))).isEqualTo("r/drive");
  }

  @Test
  void aRobotForATaskIsDistinguishedFromItsNamesakeToo() {
    assertThatThrownBy(() -> DuplicateRobotNames.choose("r", name -> List.of(FIRST, SECOND)))
        .isInstanceOf(CommandFailure.class)
        .hasMessage(
            "2 robots are named r, on 10.0.0.5 and 10.0.0.6; name one of r@10.0.0.5, r@10.0.0.6");
    assertThat(DuplicateRobotNames.choose("r@10.0.0.6", name -> List.of(FIRST, SECOND)))
        .containsExactly(SECOND);
  }
}
