package org.dfra.build;

import static com.tngtech.archunit.base.DescribedPredicate.not;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static org.assertj.core.api.Assertions.assertThat;

import com.tngtech.archunit.core.domain.JavaClasses;
import com.tngtech.archunit.lang.ArchRule;
import java.nio.file.Path;
import java.util.Arrays;

/** What the rules about dependencies share. */
final class DependencyRules {

  static final String[] API = {
    "org.dfra.module..",
    "org.dfra.lifecycle..",
    "org.dfra.geometry..",
    "org.dfra.flow..",
    "org.dfra.agent..",
    "org.dfra.behavior..",
    "org.dfra.persona..",
    "org.dfra.lease..",
    "org.dfra.event..",
    "org.dfra.directory..",
    "org.dfra.security..",
    "org.dfra.text..",
    "org.dfra.time.."
  };
  static final String[] CORE = {"org.dfra.core.."};
  static final String[] DISTRIBUTED = {"org.dfra.river.."};

  static final JavaClasses DFRA = MainClasses.ALL;

  private DependencyRules() {}

  static void check(String[] about, ArchRule rule) {
    requireSources(about);
    rule.check(DFRA);
  }

  private static void requireSources(String... about) {
    assertThat(Arrays.stream(about).filter(each -> !hasSources(each)))
        .as("packages that a rule is about and that no module has; did one get another name?")
        .isEmpty();
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

  /** What lies outside org.dfra is another rule's matter. */
  static ArchRule dependsWithinDfraOnlyOn(String[] packages, String[] allowed) {
    return noClasses()
        .that(resideInAnyPackage(packages))
        .should()
        .dependOnClassesThat(resideInAPackage("org.dfra..").and(not(resideInAnyPackage(allowed))));
  }

  static String[] join(String[]... packages) {
    return Arrays.stream(packages).flatMap(Arrays::stream).toArray(String[]::new);
  }
}
