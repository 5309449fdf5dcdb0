package org.dfra.river.access;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Method;
import java.util.Arrays;
import java.util.Set;
import java.util.stream.Collectors;
import org.dfra.river.remote.ModuleAdmin;
import org.dfra.river.remote.effector.RemoteDriveEffector;
import org.junit.jupiter.api.Test;

/** Which calls a stranger may not make. */
class AdministrativeMethodsTest {

  private static Set<String> names(Class<?> type) {
    return AdministrativeMethods.among(Arrays.asList(type.getMethods()), type).stream()
        .map(Method::getName)
        .collect(Collectors.toSet());
  }

  @Test
  void anEffectorHasThese() {
    assertThat(names(RemoteDriveEffector.class))
        .containsExactlyInAnyOrder(
            "startDiagnostic",
            "releaseEmergencyStop",
            "setInputs",
            "setLogLevel",
            "setOutputs",
            "setParameter");
  }

  @Test
  void theAdministratorOfAModuleHasThese() {
    assertThat(names(ModuleAdmin.class))
        .containsExactlyInAnyOrder(
            "addLookupAttributes",
            "addLookupGroups",
            "addLookupLocators",
            "deactivate",
            "destroy",
            "modifyLookupAttributes",
            "removeLookupGroups",
            "removeLookupLocators",
            "revoke",
            "setLookupGroups",
            "setLookupLocators");
  }
}
