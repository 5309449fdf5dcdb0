package org.dfra.build;

import static com.tngtech.archunit.base.DescribedPredicate.describe;
import static com.tngtech.archunit.base.DescribedPredicate.not;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAPackage;
import static com.tngtech.archunit.core.domain.JavaClass.Predicates.resideInAnyPackage;
import static com.tngtech.archunit.core.domain.properties.HasName.Predicates.nameStartingWith;
import static com.tngtech.archunit.lang.syntax.ArchRuleDefinition.noClasses;
import static org.assertj.core.api.Assertions.assertThat;
import static org.dfra.build.DependencyRules.API;
import static org.dfra.build.DependencyRules.CORE;
import static org.dfra.build.DependencyRules.DFRA;
import static org.dfra.build.DependencyRules.DISTRIBUTED;
import static org.dfra.build.DependencyRules.check;
import static org.dfra.build.DependencyRules.dependsWithinDfraOnlyOn;
import static org.dfra.build.DependencyRules.join;

import com.tngtech.archunit.core.domain.JavaClass;
import com.tngtech.archunit.core.domain.JavaClasses;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/** The arrows within the distributed layer: what a client downloads, the daemon, and the rest. */
class DistributedLayerTest {

  private static final String[] PROXY = {"org.dfra.river.proxy.."};
  private static final String[] REMOTE = {"org.dfra.river.remote.."};

  /** A listener's end of a subscription is exported. */
  private static final String[] CALL = {"org.dfra.river.call.."};

  private static final String[] FILTER = {"org.dfra.river.filter.."};
  private static final String[] TRANSPORT = {"org.dfra.river.transport.."};
  private static final String[] ENTRY = {"org.dfra.river.entry.."};
  private static final String[] CLIENT = {
    "org.dfra.river.remote..",
    "org.dfra.river.proxy..",
    "org.dfra.river.entry..",
    "org.dfra.river.access..",
    "org.dfra.river.call..",
    "org.dfra.river.filter..",
    "org.dfra.river.transport..",
    "org.dfra.river.identity.."
  };
  private static final String[] PHOENIX = {"org.dfra.river.phoenix.."};
  private static final String[] ACCESS = {"org.dfra.river.access.."};
  private static final String[] IDENTITY = {"org.dfra.river.identity.."};
  private static final String[] SECURITY = {"org.dfra.river.security.."};

  /** With the activation API that the JDK no longer has. */
  private static final String[] BOOT_PATH = {"org.dfra.activation.."};

  private static final String[] LOADING = {"org.dfra.river.loading.."};
  private static final String JERI_ACTIVATION_ID = "org.dfra.river.phoenix.JeriActivationID";

  @Test
  void theDistributedLayerNeedsTheApiAndCoreOnly() {
    check(
        DISTRIBUTED, dependsWithinDfraOnlyOn(DISTRIBUTED, join(DISTRIBUTED, BOOT_PATH, API, CORE)));
  }

  /** A client downloads it, and has River and the API's jar beside it. */
  @Test
  void whatAClientDownloadsNeedsTheApiOnly() {
    check(CLIENT, dependsWithinDfraOnlyOn(CLIENT, join(CLIENT, API)));
    JavaClasses module =
        DFRA.that(describe("in dfra-client", each -> moduleOf(each).equals("dfra-client")));
    assertThat(module.contain(JERI_ACTIVATION_ID)).isTrue();
    noClasses()
        .should()
        .dependOnClassesThat(
            resideInAPackage("org.dfra..")
                .and(not(resideInAnyPackage(join(CLIENT, API))))
                .and(not(nameStartingWith(JERI_ACTIVATION_ID))))
        .check(module);
  }

  /** Bring-up starts phoenix; phoenix knows neither bring-up nor servers nor lookup. */
  @Test
  void phoenixNeedsItsSecurityTheLoadingOfCodeAndWhatAClientDownloadsOnly() {
    check(
        PHOENIX,
        dependsWithinDfraOnlyOn(
            PHOENIX, join(PHOENIX, SECURITY, LOADING, BOOT_PATH, CLIENT, API, CORE)));
  }

  /** Endpoints get an identity. It does not know how bytes travel. */
  @Test
  void identitiesNeedAddressesOnly() {
    check(IDENTITY, dependsWithinDfraOnlyOn(IDENTITY, join(IDENTITY, ACCESS, API)));
  }

  /** Every process of a robot and every command has it, so it knows none of them. */
  @Test
  void theSecurityOfAProcessNeedsIdentitiesTheTransportAndCallsOnly() {
    check(
        SECURITY,
        dependsWithinDfraOnlyOn(
            SECURITY, join(SECURITY, IDENTITY, TRANSPORT, CALL, LOADING, API, CORE)));
  }

  @Test
  void theLoadingOfCodeNeedsNoPhoenix() {
    check(LOADING, dependsWithinDfraOnlyOn(LOADING, join(LOADING, FILTER, TRANSPORT, API, CORE)));
  }

  /** Its name is recorded in journals and proxies, so it keeps its package; nothing else may. */
  @Test
  void oneClassOnlyIsInAPackageOfAnotherModule() {
    Map<String, Set<String>> modules = new TreeMap<>();
    DFRA.forEach(
        each ->
            modules
                .computeIfAbsent(each.getPackageName(), p -> new TreeSet<>())
                .add(moduleOf(each)));
    modules.values().removeIf(of -> of.size() == 1);
    assertThat(modules)
        .containsExactly(
            Map.entry("org.dfra.river.phoenix", Set.of("dfra-client", "dfra-phoenix")));
    assertThat(
            DFRA.stream()
                .filter(each -> each.getPackageName().equals("org.dfra.river.phoenix"))
                .filter(each -> moduleOf(each).equals("dfra-client"))
                .map(each -> each.getName().replaceAll("\\$.*", ""))
                .filter(name -> !name.endsWith(".package-info")))
        .isNotEmpty()
        .containsOnly(JERI_ACTIVATION_ID);
  }

  /** It keeps the identity with which it was received. */
  @Test
  void aProxyNeedsTheApiTheRemoteInterfaceTheEntriesCallsAndItsIdentityOnly() {
    check(PROXY, dependsWithinDfraOnlyOn(PROXY, join(PROXY, API, REMOTE, ENTRY, CALL, IDENTITY)));
  }

  @Test
  void aRemoteInterfaceNeedsTheApiOnly() {
    check(REMOTE, dependsWithinDfraOnlyOn(REMOTE, join(REMOTE, API)));
  }

  @Test
  void anEntryNeedsTheApiAndTheFilterOnly() { // which finds classes by names that were received
    check(ENTRY, dependsWithinDfraOnlyOn(ENTRY, join(ENTRY, API, FILTER)));
  }

  /** The module of the source, by the place of its classes: a folder of this checkout or a jar. */
  private static String moduleOf(JavaClass each) {
    String place = each.getSource().orElseThrow().getUri().toString();
    Matcher found = Pattern.compile("/(dfra-\\w+)(?=[./])").matcher(place);
    String module = null;
    while (found.find()) {
      module = found.group(1);
    }
    assertThat(module).as("the module that %s is from", place).isNotNull();
    return module;
  }
}
