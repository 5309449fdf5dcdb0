package org.dfra.policy;

import java.lang.reflect.Method;
import java.util.EnumSet;
import java.util.Set;
import org.dfra.core.policy.method.MethodKind;
import org.dfra.core.policy.method.MethodKinds;
import org.dfra.security.Caller;
import org.dfra.security.Caller.Standing;
import org.dfra.security.MemberRole;

/**
 * What the policy that DFRA brings is to permit, written a second time without the policy's own
 * terms.
 */
final class ExpectedPermissions {

  private static final Set<String> ACTIVATION_SYSTEM =
      Set.of(
          "java.rmi.activation.ActivationSystem",
          "java.rmi.activation.ActivationMonitor",
          "java.rmi.activation.ActivationInstantiator",
          "com.sun.jini.phoenix.ActivationAdmin",
          "org.dfra.river.phoenix.PhoenixAdmin",
          "org.dfra.river.phoenix.ReadinessMonitor");

  private static final Set<String> PUBLIC =
      Set.of(
          "Module.identification",
          "Module.readiness",
          "Registrar.lookup",
          "Registrar.getEntryClasses",
          "Registrar.getFieldValues",
          "Registrar.getServiceTypes",
          "Registrar.getLocator",
          "ServiceProxyAccessor.getServiceProxy",
          "DiscoveryAdmin.getMemberGroups");

  private static final Set<MethodKind> OBSERVER =
      EnumSet.of(MethodKind.READ, MethodKind.LISTEN, MethodKind.LEASE, MethodKind.ACTIVATE);

  private ExpectedPermissions() {}

  /**
   * Whether a call is to be permitted.
   *
   * @param type the called object's interface
   * @param robot whose object is called; empty for what belongs to no robot
   */
  static boolean permit(Caller caller, Class<?> type, Method method, String robot) {
    MethodKind kind = MethodKinds.of(type, method).kind();
    String owner = method.getDeclaringClass().getName();
    if (caller.standing() == Standing.OWN) {
      return true;
    } else if (kind == MethodKind.STOP) {
      return caller.standing() != Standing.STRANGER;
    } else if (ACTIVATION_SYSTEM.contains(owner)) {
      return false;
    } else if (kind == MethodKind.REGISTER && !robot.isEmpty()) {
      return caller.standing() == Standing.MEMBER
          && caller.member().orElseThrow().role() == MemberRole.ROBOT;
    } else if (caller.standing() != Standing.MEMBER) {
      return isPublic(type, method);
    } else if (owner.equals("org.dfra.river.security.news.TeamNews")) {
      return true; // the authority has signed it
    }
    return switch (caller.member().orElseThrow().role()) {
      case OPERATOR -> true;
      case OBSERVER -> OBSERVER.contains(kind);
      case ROBOT ->
          OBSERVER.contains(kind) || kind == MethodKind.DELIVER || kind == MethodKind.REGISTER;
    };
  }

  /** Of a registrar, only it has the public methods that it inherits. */
  private static boolean isPublic(Class<?> type, Method method) {
    String name = method.getDeclaringClass().getSimpleName() + "." + method.getName();
    boolean isOfRegistrar =
        Set.of("ServiceProxyAccessor", "DiscoveryAdmin")
            .contains(method.getDeclaringClass().getSimpleName());
    return PUBLIC.contains(name)
        && (!isOfRegistrar || type.getName().equals("com.sun.jini.reggie.Registrar"));
  }
}
