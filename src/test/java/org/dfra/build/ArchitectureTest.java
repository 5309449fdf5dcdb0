package org.dfra.build;

import static com.tngtech.archunit.base.DescribedPredicate.describe;
import static com.tngtech.archunit.base.DescribedPredicate.not;
import static com.tngtech.archunit.core.domain.JavaAccess.Predicates.target;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.assignableTo;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.equivalentTo;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.core.domain.properties.HasName.Predicates.name;
import static com.tngtech.archunit.core.domain.properties.HasOwner.Predicates.With.owner;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static com.tngtech.archunit.library.dependencies.SlicesRuleDefinition.slices;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.dfra.build.DependencyRules.API;
import static org.dfra.build.DependencyRules.CORE;
import static org.dfra.build.DependencyRules.DFRA;
import static org.dfra.build.DependencyRules.DISTRIBUTED;
import static org.dfra.build.DependencyRules.check;
import static org.dfra.build.DependencyRules.dependsWithinDfraOnlyOn;
import static org.dfra.build.DependencyRules.join;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaAccess;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.lang.ArchRule;
import java.time.Instant;
import java.util.Arrays;
import org.dfra.report.measurement.ReportHead;
import org.dfra.report.measurement.RunMeasurements;
import org.dfra.report.plot.HtmlReport;
import org.dfra.report.plot.NoFontException;
import org.dfra.time.Scheduler;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Dependencies between modules and packages have one direction.
 *
 * <p>A rule about a package that has no source fails, so a package that is renamed takes its rules
 * along; one whose sources exist but whose classes are not found fails too, since ArchUnit refuses
 * a rule that checks nothing.
 *
 * <p>The rules for printed text are checked here too, since they read the same classes.
 */
class ArchitectureTest extends PrintedTextRules {

  private static final String[] RIVER = {
    "net.jini..",
    "com.sun.jini..",
    "com.artima..",
    "org.apache.river..",
    "java.rmi.activation..",
    "org.dfra.river.."
  };
  private static final String[] JDK = {
    "java..", "javax..", "jdk..", "org.w3c.dom..", "org.xml.sax.."
  };
  private static final String[] ANNOTATIONS = {
    "org.jspecify.annotations..", "com.google.errorprone.annotations.."
  };
  private static final String[] LOG = {"org.slf4j.."};
  private static final String[] DRIVERS = {"org.dfra.drivers.."};
  private static final String[] FLIGHT = {"org.dfra.drivers.uav.."};
  private static final String[] MAVLINK = {"io.dronefleet.mavlink.."};
  private static final String[] SIM = {"org.dfra.sim.."};

  /** The modules of the application: each may need those before it. */
  private static final String[] APPLICATION = {
    "org.dfra.report..",
    "org.dfra.cli..",
    "org.dfra.authority..",
    "org.dfra.examples..",
    "org.dfra.experiments..",
    "org.dfra.benchmarks.."
  };

  private static final String[] TESTING = {"org.dfra.testing.."};
  private static final String[] JUNIT = {"org.junit.jupiter.api.extension.."};

  @Test
  void theApiNeedsTheJdkOnly() {
    check(API, onlyDependsOn(API, join(API, JDK, ANNOTATIONS)));
  }

  @Test
  void noPackagesNeedEachOther() {
    slices().matching("org.dfra.(**)").should().beFreeOfCycles().check(DFRA);
  }

  @Test
  void theApiNamesNoRiverTypeAndNoActivation() {
    check(
        API,
        noClasses()
            .that(resideInAnyPackage(API))
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage(RIVER));
  }

  @Test
  void coreNeedsTheApiXmlJsonMatricesAndLogOnly() {
    String[] jdom = {"org.jdom2.."};
    String[] jackson = {"com.fasterxml.jackson.core..", "com.fasterxml.jackson.databind.."};
    String[] ejml = {"org.ejml.."};
    check(CORE, onlyDependsOn(CORE, join(CORE, API, JDK, ANNOTATIONS, LOG, jdom, jackson, ejml)));
  }

  /** Of the drivers only their links, which it is at the other end of: no protocol. */
  @Test
  void simulationNeedsTheApiCoreAndLinksOnly() {
    String[] links = {"org.dfra.drivers.link"};
    check(SIM, dependsWithinDfraOnlyOn(SIM, join(SIM, API, CORE, links)));
  }

  @Test
  void driversNeedTheApiAndCoreOnly() {
    check(DRIVERS, dependsWithinDfraOnlyOn(DRIVERS, join(DRIVERS, API, CORE)));
  }

  /** They are in dfra-flight, which a robot that does not fly lacks. */
  @Test
  void nothingNamesADriverOfAFlightControllerOrNeedsMavlink() {
    check(
        FLIGHT,
        noClasses()
            .that(not(resideInAnyPackage(FLIGHT)))
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage(join(FLIGHT, MAVLINK)));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"org.dfra.core..", "org.dfra.drivers..", "org.dfra.behaviors..", "org.dfra.sim.."})
  void whatRunsOnARobotWithoutANetworkNeverNeedsRiver(String part) {
    check(new String[] {part}, neverDependsOnRiver(part));
  }

  /** But for its five classes over River, which are in a package of their own. */
  @Test
  void recruitmentsLogicNeedsTheApiAndCoreOnly() {
    check(
        new String[] {"org.dfra.recruit.."},
        noClasses()
            .that(
                resideInAPackage("org.dfra.recruit..")
                    .and(not(resideInAPackage("org.dfra.recruit.river.."))))
            .should()
            .dependOnClassesThat(
                resideInAPackage("org.dfra..")
                    .and(
                        not(
                            resideInAnyPackage(
                                join(API, CORE, new String[] {"org.dfra.recruit.."}))))));
  }

  @Test
  void recruitmentsLogicNeverNeedsRiver() {
    check(
        new String[] {"org.dfra.recruit.."},
        noClasses()
            .that(
                resideInAPackage("org.dfra.recruit..")
                    .and(not(resideInAPackage("org.dfra.recruit.river.."))))
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage(RIVER));
  }

  @Test
  void perceptionNeverKnowsAction() {
    check(
        new String[] {"org.dfra.flow.perceptual.."},
        noClasses()
            .that()
            .resideInAPackage("org.dfra..perceptual..")
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage("org.dfra..motor..", "org.dfra..effector.."));
  }

  @Test
  void onlyTheApplicationNamesADriverAndTheSimulationTheirLinks() {
    check(
        DRIVERS,
        noClasses()
            .that(not(resideInAnyPackage(join(DRIVERS, SIM, APPLICATION))))
            .should()
            .dependOnClassesThat()
            .resideInAPackage("org.dfra.drivers.."));
  }

  @Test
  void onlyTheApplicationNamesTheSimulation() {
    check(
        SIM,
        noClasses()
            .that(not(resideInAnyPackage(join(SIM, APPLICATION))))
            .should()
            .dependOnClassesThat()
            .resideInAPackage("org.dfra.sim.."));
  }

  /** It is a jar of its own, so that tests elsewhere get no second assertion library with it. */
  @Test
  void theHarnessForTestsNeedsTheDistributedLayerAndJUnitOnly() {
    check(
        TESTING,
        onlyDependsOn(
            TESTING, join(TESTING, API, CORE, DISTRIBUTED, RIVER, JDK, ANNOTATIONS, JUNIT)));
  }

  @Test
  void nothingThatRunsOnARobotNeedsTheHarnessForTests() {
    check(
        TESTING,
        noClasses()
            .that(not(resideInAnyPackage(TESTING)))
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage(TESTING));
  }

  /** So no control loop, renewal or delivery can make one late; see what-stops-a-robot.md. */
  @Test
  void onlyCommandTimeoutsUseTheirTimer() {
    DescribedPredicate<JavaAccess<?>> timer =
        target(name("commandTimer")).and(target(owner(assignableTo(Scheduler.class))));
    String timeout = "org.dfra.core.effector.CommandTimeout";
    DescribedPredicate<JavaClass> time = assignableTo(Scheduler.class).as("a time itself");
    check(
        CORE, noClasses().that(not(time).and(not(name(timeout)))).should().callMethodWhere(timer));
    check(CORE, classes().that().haveFullyQualifiedName(timeout).should().callMethodWhere(timer));
    check(
        CORE,
        noClasses()
            .that(not(resideInAPackage("org.dfra.core.effector")))
            .should()
            .dependOnClassesThat()
            .haveFullyQualifiedName(timeout));
  }

  @Test
  void theApplicationsModulesNeedThoseBelowThemOnly() {
    for (int i = 0; i < APPLICATION.length; i++) {
      String[] above = Arrays.copyOfRange(APPLICATION, i + 1, APPLICATION.length);
      if (above.length > 0) {
        String[] module = {APPLICATION[i]};
        check(
            APPLICATION,
            noClasses()
                .that(resideInAnyPackage(module))
                .should()
                .dependOnClassesThat()
                .resideInAnyPackage(above));
      }
    }
  }

  @Test
  void nothingBelowTheApplicationNeedsIt() {
    check(
        APPLICATION,
        noClasses()
            .that(not(resideInAnyPackage(APPLICATION)))
            .should()
            .dependOnClassesThat()
            .resideInAnyPackage(APPLICATION));
  }

  /** A robot has no XChart and no Batik: its verbs use the terminal's part of the reports. */
  @Test
  void theVerbsOfARobotPlotNothing() {
    String[] cli = {"org.dfra.cli.."};
    String[] terminal = {"org.dfra.report.terminal.."};
    DescribedPredicate<JavaClass> rest =
        resideInAPackage("org.dfra.report..")
            .and(not(resideInAnyPackage(terminal)))
            .and(not(equivalentTo(NoFontException.class)));
    check(cli, noClasses().that(resideInAnyPackage(cli)).should().dependOnClassesThat(rest));
    check(
        terminal,
        noClasses().that(resideInAnyPackage(terminal)).should().dependOnClassesThat(rest));
  }

  /** A robot checks certificates with the JDK alone; only the authority's tool writes them. */
  @Test
  void onlyTheAuthorityWritesCertificates() {
    String[] authority = {"org.dfra.authority.."};
    String[] fixture = {"org.dfra.river.fixture.."}; // of tests
    check(
        authority,
        noClasses()
            .that(not(resideInAnyPackage(join(authority, fixture))))
            .should()
            .dependOnClassesThat()
            .resideInAPackage("org.bouncycastle.."));
  }

  @Test
  void everyReportBeginsWithItsVerdictAndItsTargets() {
    check(
        APPLICATION,
        classes()
            .that(
                describe(
                    "make a report",
                    each ->
                        each.getConstructorCallsFromSelf().stream()
                            .anyMatch(
                                call -> call.getTargetOwner().isEquivalentTo(HtmlReport.class))))
            .should()
            .callMethod(
                ReportHead.class, "add", HtmlReport.class, RunMeasurements.class, Instant.class));
  }

  @Test
  void aRuleThatIsBrokenFails() {
    JavaClasses thisTest = new ClassFileImporter().importClasses(ArchitectureTest.class);
    String[] build = {"org.dfra.build.."};
    assertThatThrownBy(() -> onlyDependsOn(build, join(build, JDK)).check(thisTest))
        .isInstanceOf(AssertionError.class)
        .hasMessageContaining("com.tngtech.archunit");
    assertThatThrownBy(() -> neverDependsOnRiver("org.dfra.nowhere..").check(thisTest))
        .as("a rule that checks nothing")
        .isInstanceOf(AssertionError.class);
    assertThatThrownBy(() -> check(new String[] {"org.dfra.core..", "org.dfra.app.."}, null))
        .as("a rule about a package that has another name now")
        .isInstanceOf(AssertionError.class)
        .hasMessageContaining("org.dfra.app..");
  }

  @Test
  void theRulesSeeTheClasses() {
    assertThat(DFRA.contain("org.dfra.module.Module")).isTrue();
    assertThat(DFRA.contain("org.dfra.core.module.ModuleImpl")).isTrue();
  }

  private static ArchRule onlyDependsOn(String[] packages, String[] allowed) {
    return classes()
        .that(resideInAnyPackage(packages))
        .should()
        .onlyDependOnClassesThat(anyOf(allowed));
  }

  private static ArchRule neverDependsOnRiver(String packages) {
    return noClasses()
        .that()
        .resideInAPackage(packages)
        .should()
        .dependOnClassesThat()
        .resideInAnyPackage(RIVER);
  }

  /** Also arrays of primitive types, which lie in no package at all. */
  private static DescribedPredicate<JavaClass> anyOf(String[] packages) {
    return resideInAnyPackage(packages).or(resideInAPackage(""));
  }
}
