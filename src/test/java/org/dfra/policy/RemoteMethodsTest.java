package org.dfra.policy;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Method;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.dfra.core.policy.method.InterfaceCatalogue;
import org.dfra.core.policy.method.InterfaceCatalogue.CataloguedInterface;
import org.dfra.core.policy.method.MethodKind;
import org.dfra.core.policy.method.MethodKinds;
import org.dfra.module.Administrative;
import org.dfra.module.Idempotent;
import org.dfra.module.StopsRobot;
import org.junit.jupiter.api.Test;

/** Each remote method has a kind for a reason: none is new, forgotten or only assumed. */
class RemoteMethodsTest {

  private static final InterfaceCatalogue CATALOGUE = InterfaceCatalogue.builtIn();

  /** They only read, but no annotation says so: each has been looked at. */
  private static final Set<String> READ_WITHOUT_ANNOTATION =
      Set.of(
          "org.dfra.river.phoenix.PhoenixAdmin.groupStatus",
          "org.dfra.river.phoenix.PhoenixAdmin.activeObjects",
          "org.dfra.river.phoenix.PhoenixAdmin.activeProxy",
          "org.dfra.river.phoenix.ReadinessMonitor.minReadyMillis");

  @Test
  void findsTheRemoteInterfacesOfAllParts() {
    assertThat(RemoteInterfaces.ALL)
        .extracting(Class::getName)
        .contains(
            "com.sun.jini.reggie.Registrar",
            "com.sun.jini.landlord.Landlord",
            "java.rmi.activation.ActivationSystem",
            "java.rmi.activation.Activator",
            "net.jini.core.event.RemoteEventListener",
            "org.dfra.recruit.river.RemoteRecruitmentAgent",
            "org.dfra.river.phoenix.stop.StopService",
            "org.dfra.river.remote.ModuleAdmin",
            "org.dfra.river.remote.effector.RemoteDriveEffector")
        .hasSizeGreaterThan(35);
    RemoteInterfaces.NOT_ON_ROBOTS.forEach(RemoteInterfaces::load);
  }

  @Test
  void theCatalogueHasExactlyTheRemoteInterfacesAndTheirMethods() {
    Map<String, Set<String>> found = new TreeMap<>();
    for (Class<?> each : RemoteInterfaces.WITH_SUPERINTERFACES) {
      found.put(
          each.getName(),
          RemoteInterfaces.declared(each).stream()
              .map(Method::getName)
              .collect(Collectors.toCollection(TreeSet::new)));
    }
    Map<String, Set<String>> catalogued = new TreeMap<>();
    CATALOGUE
        .all()
        .forEach(each -> catalogued.put(each.name(), new TreeSet<>(each.declared().keySet())));

    assertThat(catalogued)
        .as("remote-interfaces.tsv; a new remote method needs a line with its kind and the reason")
        .isEqualTo(found);
  }

  @Test
  void theCatalogueKnowsWhatEachInterfaceExtends() {
    for (Class<?> each : RemoteInterfaces.WITH_SUPERINTERFACES) {
      Set<String> supers =
          MethodKinds.interfaces(each).stream()
              .filter(RemoteInterfaces.WITH_SUPERINTERFACES::contains)
              .filter(above -> above != each)
              .map(Class::getName)
              .collect(Collectors.toSet());
      assertThat(CATALOGUE.find(each.getName()).orElseThrow().superinterfaces())
          .as("superinterfaces of %s", each.getName())
          .containsExactlyInAnyOrderElementsOf(supers);
    }
  }

  @Test
  void everyRemoteMethodHasAKindForAReason() {
    List<String> assumed = new ArrayList<>();
    int methods = 0;
    for (Class<?> each : RemoteInterfaces.ALL) {
      for (Method method : each.getMethods()) {
        methods++;
        MethodKinds.Classification kind = MethodKinds.of(each, method);
        if (!kind.isDeclared() || kind.reason().isBlank()) {
          assumed.add(each.getName() + "." + method.getName());
        }
      }
    }
    assertThat(assumed).isEmpty();
    assertThat(methods).isGreaterThan(500);
  }

  @Test
  void capacityIsKeptForExactlyTheStops() {
    for (Class<?> type : RemoteInterfaces.WITH_SUPERINTERFACES) {
      for (Method method : RemoteInterfaces.declared(type)) {
        assertThat(method.isAnnotationPresent(StopsRobot.class))
            .as("@StopsRobot of %s", method)
            .isEqualTo(MethodKinds.of(type, method).kind() == MethodKind.STOP);
      }
    }
  }

  /** The table and the annotations cannot disagree about what is dangerous. */
  @Test
  void theKindsFitTheAnnotations() {
    for (Class<?> type : RemoteInterfaces.WITH_SUPERINTERFACES) {
      CataloguedInterface known = CATALOGUE.find(type.getName()).orElseThrow();
      for (Method method : RemoteInterfaces.declared(type)) {
        String name = type.getName() + "." + method.getName();
        MethodKind kind = known.declared().get(method.getName()).kind();
        boolean isAdministrative = method.isAnnotationPresent(Administrative.class);
        if (isAdministrative) {
          assertThat(kind).as(name).isIn(MethodKind.ADMINISTER, MethodKind.RELEASE);
        }
        if (type.getName().startsWith("org.dfra.") && kind == MethodKind.READ) {
          assertThat(method.isAnnotationPresent(Idempotent.class))
              .as("%s is marked as a query, or known as one", name)
              .isEqualTo(!READ_WITHOUT_ANNOTATION.contains(name));
          assertThat(method.getReturnType()).as(name).isNotEqualTo(void.class);
          assertThat(isAdministrative).as(name).isFalse();
        }
      }
    }
  }
}
