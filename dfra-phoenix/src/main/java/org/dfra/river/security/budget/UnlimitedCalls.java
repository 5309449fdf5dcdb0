package org.dfra.river.security.budget;

import java.lang.reflect.Method;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Predicate;
import org.dfra.core.policy.method.MethodKinds;
import org.dfra.river.security.news.TeamNews;
import org.dfra.security.AccessRequest;
import org.dfra.security.Caller.Standing;
import org.jspecify.annotations.Nullable;

/**
 * The calls that no budget refuses or slows: emergency stops, what lets a robot stand or keeps a
 * lease, how a member finds the robots that it wants to stop, how lists of revoked certificates and
 * policies pass between members, and everything that a robot's own processes call.
 */
public final class UnlimitedCalls implements Predicate<AccessRequest> {

  private static final Set<String> LEASES =
      Set.of(
          "renew",
          "renewAll",
          "cancel",
          "cancelAll",
          "renewServiceLease",
          "cancelServiceLease",
          "renewEventLease",
          "cancelEventLease",
          "renewLeases",
          "cancelLeases");

  private static final Set<String> STANDING =
      Set.of("pause", "pauseUnattended", "cancel", "cancelUnattended");

  /** Of lookup services. */
  private static final Set<String> FINDING =
      Set.of(
          "lookup",
          "getServiceProxy",
          "getFieldValues",
          "getEntryClasses",
          "getServiceTypes",
          "getLocator");

  /** Of {@link TeamNews}: without them, a budget that is too small could not be replaced. */
  private static final Set<String> NEWS =
      Set.of("numbers", "revocations", "policy", "takeRevocations", "takePolicy");

  private static final int MAX_KNOWN = 10_000;

  private final ConcurrentHashMap<TypedMethod, Boolean> known = new ConcurrentHashMap<>();

  private record TypedMethod(Class<?> type, Method method) {

    /** Faster than that of a record, above all with the first compiler alone. */
    @Override
    public int hashCode() {
      return 31 * type.hashCode() + method.getName().hashCode();
    }

    @Override
    public boolean equals(@Nullable Object other) {
      return other instanceof TypedMethod typed
          && type == typed.type
          && method.equals(typed.method);
    }
  }

  @Override
  public boolean test(AccessRequest request) {
    if (request.caller().standing() == Standing.OWN) {
      return true;
    }
    TypedMethod key = new TypedMethod(request.type(), request.method());
    Boolean found = known.get(key);
    if (found == null) {
      if (known.size() >= MAX_KNOWN) {
        known.clear();
      }
      found = isUnlimited(request.type(), request.method());
      known.put(key, found);
    }
    // A stranger stops nobody, so it need not find anybody to stop, and it brings no news.
    return found
        && (request.caller().standing() != Standing.STRANGER
            || !(FINDING.contains(request.method().getName())
                || isNews(request.method().getDeclaringClass())));
  }

  private static boolean isUnlimited(Class<?> type, Method method) {
    String name = method.getName();
    if (isNews(method.getDeclaringClass())) {
      return NEWS.contains(name);
    }
    return switch (MethodKinds.of(type, method).kind()) {
      case STOP -> true;
      case LEASE -> LEASES.contains(name);
      case COMMAND -> STANDING.contains(name);
      case READ -> FINDING.contains(name);
      default -> false;
    };
  }

  private static boolean isNews(Class<?> type) {
    return type == TeamNews.class;
  }
}
