package org.dfra.cli.doctor;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.dfra.cli.doctor.CheckRunner.Check;
import org.dfra.core.host.CommandName;
import org.jspecify.annotations.Nullable;

/** Checks whether the team's lookup services answer, and how quickly. */
final class RegistrarCheck implements Check {

  private static final Duration SLOW = Duration.ofMillis(500);

  /**
   * A discovered lookup service.
   *
   * @param locator its locator, {@code jini://host:port}
   * @param groups its discovery groups
   * @param loopback whether its address is a loopback address, which leads every other computer to
   *     itself
   * @param responseTime of a call; null if it did not answer
   */
  record SurveyedRegistrar(
      String locator, List<String> groups, boolean loopback, @Nullable Duration responseTime) {

    SurveyedRegistrar {
      groups = List.copyOf(groups);
    }
  }

  /**
   * The survey's result.
   *
   * @param seen the lookup services
   * @param unreachable the locators that did not answer
   */
  record Survey(List<SurveyedRegistrar> seen, List<String> unreachable) {

    Survey {
      seen = List.copyOf(seen);
      unreachable = List.copyOf(unreachable);
    }
  }

  /** Discovers lookup services. */
  interface Search {
    Survey survey() throws InterruptedException;
  }

  private final Search search;
  private final List<String> named;
  private final boolean isRobotUp;

  /**
   * @param named locators that the user named, which must answer
   * @param isRobotUp whether robots are up on this host, whose registrars must answer
   */
  RegistrarCheck(Search search, List<String> named, boolean isRobotUp) {
    this.search = search;
    this.named = named.stream().map(RegistrarCheck::plain).toList();
    this.isRobotUp = isRobotUp;
  }

  @Override
  public Subject subject() {
    return Subject.REGISTRAR;
  }

  @Override
  public List<Finding> run() throws InterruptedException {
    Survey survey = search.survey();
    List<Finding> findings = new ArrayList<>();
    survey.seen().forEach(each -> findings.add(of(each)));
    for (String silent : survey.unreachable()) {
      String locator = plain(silent);
      if (named.contains(locator)) {
        findings.add(
            Finding.fail(
                subject(),
                "none answers at " + locator,
                "Bring its robot up, let a firewall pass its TCP port, or correct --locator or"
                    + " DFRA_LOCATORS."));
      } else if (isRobotUp) {
        findings.add(
            Finding.fail(
                subject(),
                "that of this host at " + locator + " does not answer",
                "See how its group is: " + CommandName.current() + " status."));
      }
    }
    if (findings.isEmpty()) {
      findings.add(
          Finding.warn(
              subject(),
              "none was found",
              "Bring a robot up, or name the registrar of one in DFRA_LOCATORS where multicast"
                  + " does not reach."));
    }
    return findings;
  }

  /** In the usual notation; River appends a slash. */
  private static String plain(String locator) {
    return locator.endsWith("/") ? locator.substring(0, locator.length() - 1) : locator;
  }

  private Finding of(SurveyedRegistrar seen) {
    String name =
        seen.locator()
            + (seen.groups().isEmpty() ? "" : " of group " + String.join(", ", seen.groups()));
    if (seen.responseTime() == null) {
      return Finding.fail(
          subject(),
          name + " was found and does not answer",
          "Its process is stopped or overloaded, or out of radio range: ask "
              + CommandName.current()
              + " status on its"
              + " host.");
    }
    String what = name + " answers in " + DurationText.of(seen.responseTime());
    if (seen.loopback() && !seen.groups().isEmpty()) {
      return Finding.warn(
          subject(),
          what + ", but only on this computer, though others may look for that group",
          "Take the robot down, name the address that others reach as host in its XML or in"
              + " DFRA_HOST, and bring it up again.");
    }
    return seen.responseTime().compareTo(SLOW) < 0
        ? Finding.ok(subject(), what)
        : Finding.warn(
            subject(),
            what,
            "The network is slow or its host overloaded; calls end after 2 s unless configured"
                + " otherwise.");
  }
}
