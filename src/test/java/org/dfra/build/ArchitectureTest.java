package org.dfra.build;

import static com.tngtech.archunit.base.DescribedPredicate.describe;
import static com.tngtech.archunit.base.DescribedPredicate.not;
import static com.tngtech.archunit.core.domain.JavaAccess.Predicates.target;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.assignableTo;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.core.domain.properties.HasName.Predicates.name;
import static com.tngtech.archunit.core.domain.properties.HasOwner.Predicates.With.owner;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.classes;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.tngtech.archunit.base.DescribedPredicate;
import com.tngtech.archunit.core.domain.JavaAccess;
import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.core.importer.ClassFileImporter;
import com.tngtech.archunit.lang.ArchRule;
import java.nio.file.Path;
import java.time.Instant;
import java.util.Arrays;
import org.dfra.app.measurement.ReportHead;
import org.dfra.app.measurement.RunMeasurements;
import org.dfra.app.plot.HtmlReport;
import org.dfra.time.Scheduler;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The arrows of the house point one way.
 *
 * <p>A rule about a package that has no source yet is skipped and says so; one whose sources exist
 * but whose classes are not found fails, since ArchUnit refuses a rule that checks nothing.
 *
 * <p>Also who shows text to people is checked here, since the same classes are read for it.
 */
class ArchitectureTest extends PrintedTextRules {

  private static final String[] API = {
    "org.dfra.module..",
    "org.dfra.geometry..",
    "org.dfra.flow..",
    "org.dfra.agent..",
    "org.dfra.behavior..",
    "org.dfra.manager..",
    "org.dfra.persona..",
    "org.dfra.lease..",
    "org.dfra.event..",
    "org.dfra.directory..",
    "org.dfra.text..",
    "org.dfra.time.."
  };
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
  private static final String[] NULLNESS = {"org.jspecify.annotations.."};
  private static final String[] LOG = {"org.slf4j.."};
  private static final String[] CORE = {"org.dfra.core.."};
  private static final String[] DRIVERS = {"org.dfra.drivers.."};
  private static final String[] SIM = {"org.dfra.sim.."};
  private static final String[] TESTING = {"org.dfra.testing.."};
  private static final String[] JUNIT = {"org.junit.jupiter.api.extension.."};
  private static final String[] DISTRIBUTED = {"org.dfra.river.."};
  private static final String[] PROXY = {"org.dfra.river.proxy.."};
  private static final String[] REMOTE = {"org.dfra.river.remote.."};

  /** A listener's end of a subscription is exported. */
  private static final String[] CALL = {"org.dfra.river.call.."};

  private static final String[] ENTRY = {"org.dfra.river.entry.."};

  private static final JavaClasses DFRA = MainClasses.ALL;

  @Test
  void theApiNeedsTheJdkOnly() {
    check(API, onlyDependsOn(API, join(API, JDK, NULLNESS)));
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
    check(CORE, onlyDependsOn(CORE, join(CORE, API, JDK, NULLNESS, LOG, jdom, jackson, ejml)));
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
  void theDistributedLayerNeedsTheApiAndCoreOnly() {
    check(DISTRIBUTED, dependsWithinDfraOnlyOn(DISTRIBUTED, join(DISTRIBUTED, API, CORE)));
  }

  @Test
  void aProxyNeedsTheApiTheRemoteInterfaceTheEntriesAndCallsOnly() {
    check(PROXY, dependsWithinDfraOnlyOn(PROXY, join(PROXY, API, REMOTE, ENTRY, CALL)));
  }

  @Test
  void aRemoteInterfaceNeedsTheApiOnly() {
    check(REMOTE, dependsWithinDfraOnlyOn(REMOTE, join(REMOTE, API)));
  }

  @Test
  void anEntryNeedsTheApiOnly() {
    check(ENTRY, dependsWithinDfraOnlyOn(ENTRY, join(ENTRY, API)));
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
            .that(not(resideInAnyPackage("org.dfra.drivers..", "org.dfra.sim..", "org.dfra.app..")))
            .should()
            .dependOnClassesThat()
            .resideInAPackage("org.dfra.drivers.."));
  }

  @Test
  void onlyTheApplicationNamesTheSimulation() {
    check(
        SIM,
        noClasses()
            .that(not(resideInAnyPackage("org.dfra.sim..", "org.dfra.app..")))
            .should()
            .dependOnClassesThat()
            .resideInAPackage("org.dfra.sim.."));
  }

  /** It is a jar of its own, so that tests elsewhere get no second assertion library with it. */
  @Test
  void theHarnessForTestsNeedsTheDistributedLayerAndJUnitOnly() {
    check(
        TESTING,
        onlyDependsOn(TESTING, join(TESTING, API, CORE, DISTRIBUTED, RIVER, JDK, NULLNESS, JUNIT)));
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
  void everyReportBeginsWithItsVerdictAndItsTargets() {
    check(
        new String[] {"org.dfra.app.."},
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
  }

  @Test
  void theRulesSeeTheClasses() {
    assertThat(DFRA.contain("org.dfra.module.Module")).isTrue();
    assertThat(DFRA.contain("org.dfra.core.module.ModuleImpl")).isTrue();
  }

  private static void check(String[] about, ArchRule rule) {
    assumeTrue(
        Arrays.stream(about).anyMatch(ArchitectureTest::hasSources),
        () -> "no source yet in " + String.join(", ", about) + ", so nothing to check");
    rule.check(DFRA);
  }

  private static boolean hasSources(String packages) {
    Path directory = Path.of(packages.substring(0, packages.length() - 2).replace('.', '/'));
    Path sources = Path.of("src/main/java");
    Path root = Repository.root();
    return Repository.mainPackages(root).stream()
        .map(root::relativize)
        .anyMatch(
            found -> found.subpath(1, found.getNameCount()).startsWith(sources.resolve(directory)));
  }

  private static ArchRule onlyDependsOn(String[] packages, String[] allowed) {
    return classes()
        .that(resideInAnyPackage(packages))
        .should()
        .onlyDependOnClassesThat(anyOf(allowed));
  }

  /** What lies outside org.dfra is another rule's matter. */
  private static ArchRule dependsWithinDfraOnlyOn(String[] packages, String[] allowed) {
    return noClasses()
        .that(resideInAnyPackage(packages))
        .should()
        .dependOnClassesThat(resideInAPackage("org.dfra..").and(not(resideInAnyPackage(allowed))));
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

  private static String[] join(String[]... packages) {
    return Arrays.stream(packages).flatMap(Arrays::stream).toArray(String[]::new);
  }
}
