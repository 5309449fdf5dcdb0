package org.dfra.cli.doctor;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.dfra.cli.doctor.Finding.Verdict;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.config.RegistrarDescription;
import org.dfra.core.config.RobotDescription;
import org.dfra.core.config.RobotDescription.AdministrationDescription;
import org.dfra.core.config.RobotDescription.GroupDescription;
import org.dfra.core.config.SourceLocation;
import org.junit.jupiter.api.Test;

class ExposureCheckTest {

  private static RobotDescription robot(String name, String host, String... administrators) {
    return robot(name, host, List.of(administrators), Optional.empty());
  }

  private static RobotDescription robot(
      String name,
      String host,
      List<String> administrators,
      Optional<RegistrarDescription> registrar) {
    return new RobotDescription(
        name,
        host,
        List.of(),
        List.of(),
        new AdministrationDescription(administrators, SourceLocation.CODE),
        Optional.empty(),
        List.of(new GroupDescription("all", List.of(), registrar, List.of(), SourceLocation.CODE)),
        Path.of(name + ".xml"));
  }

  /** A robot whose registrar takes modules from there. */
  private static RobotDescription registering(String... from) {
    RegistrarDescription registrar =
        new RegistrarDescription(4160, 8085, true, List.of(from), SourceLocation.CODE);
    return robot("atrv1", "127.0.0.1", List.of(), Optional.of(registrar));
  }

  private static List<String> warnings(RobotDescription robot) {
    return examined(robot).stream()
        .filter(each -> each.verdict() == Verdict.WARN)
        .map(Finding::what)
        .toList();
  }

  private static List<Finding> examined(RobotDescription... robots) {
    return new ExposureCheck(List.of(robots), host -> host.equals("auto") ? "192.0.2.5" : host)
        .run();
  }

  @Test
  void aRobotThatOthersReachIsAWarning() {
    assertThat(examined(robot("atrv1", "auto"), robot("atrv2", "127.0.0.1", "192.0.2.0/24")))
        .containsExactly(
            Finding.warn(
                Subject.EXPOSURE,
                "atrv1 is at 192.0.2.5, and every program that reaches this address can read and"
                    + " command it",
                "Let only computers that you trust reach this address;"
                    + " docs/concepts/security.md says what strangers can do."),
            Finding.ok(
                Subject.EXPOSURE, "atrv2 is at 127.0.0.1, which only this computer reaches"));
    assertThat(examined()).isEmpty();
  }

  @Test
  void soIsOneThatEverybodyMayAdminister() {
    assertThat(examined(robot("atrv1", "127.0.0.1", "0.0.0.0/0")))
        .contains(
            Finding.warn(
                Subject.EXPOSURE,
                "atrv1 may be administered from 0.0.0.0/0, which counts as everywhere",
                "Name the operators' addresses in <administration from=\"…\"> of its XML;"
                    + " docs/concepts/security.md says what administrators can do."));
  }

  @Test
  void theLengthOfThePrefixOfAnAdministratorsRangeCounts() {
    RobotDescription broad =
        robot("atrv1", "127.0.0.1", "0.0.0.0/1", "10.0.0.0/7", "::/0", "2000::/3", "fd00::/15");
    assertThat(warnings(broad))
        .hasSize(5)
        .allMatch(text -> text.startsWith("atrv1 may be administered from "));
    RobotDescription narrow =
        robot("atrv1", "127.0.0.1", "10.0.0.0/8", "fd00::/16", "192.0.2.1", "laptop", "fd00::1");
    assertThat(warnings(narrow)).isEmpty();
  }

  @Test
  void soDoesThatOfARangeThatARegistrarTakesModulesFrom() {
    assertThat(examined(registering("10.0.0.0/7")))
        .contains(
            Finding.warn(
                Subject.EXPOSURE,
                "the registrar of atrv1 takes modules of this robot from 10.0.0.0/7, which counts"
                    + " as everywhere",
                "Name the addresses of the robot's further computers in <registrar module-hosts=\"…\"> of"
                    + " its XML; docs/concepts/security.md says what others could register."));
    assertThat(warnings(registering("0.0.0.0/0", "fd00::/15"))).hasSize(2);
    assertThat(warnings(registering("10.0.0.0/8", "fd00::/16", "192.0.2.1", "laptop"))).isEmpty();
  }

  @Test
  void aHostThatIsNoneOfThisComputerFails() {
    List<Finding> findings =
        new ExposureCheck(
                List.of(robot("atrv1", "192.0.2.9")),
                host -> {
                  throw new ConfigurationException("host " + host + " is gone; name another");
                })
            .run();
    assertThat(findings)
        .containsExactly(Finding.fail(Subject.EXPOSURE, "host 192.0.2.9 is gone", "Name another."));
  }
}
