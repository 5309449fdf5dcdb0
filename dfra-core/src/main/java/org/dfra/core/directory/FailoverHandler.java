package org.dfra.core.directory;

import java.lang.reflect.InvocationHandler;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.rmi.ConnectException;
import java.rmi.ConnectIOException;
import java.rmi.NoSuchObjectException;
import java.rmi.RemoteException;
import java.rmi.UnknownHostException;
import java.time.Duration;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import org.dfra.directory.CallFailedException;
import org.dfra.directory.ExecutionCertainty;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.directory.NoModuleFoundException;
import org.dfra.module.Idempotent;
import org.dfra.module.Module;
import org.dfra.module.NotReadyException;
import org.jspecify.annotations.Nullable;

/**
 * The invocation handler of a failover proxy for all modules that match a query. A module that
 * failed is tried last for a while, since a lookup service lists a dead module until its lease
 * expires, and a restarted module has no data yet.
 */
final class FailoverHandler<M extends Module> implements InvocationHandler {

  private static final long AVOID_NANOS = Duration.ofSeconds(10).toNanos();

  private final ModuleQuery<M> query;
  private final Supplier<List<ModuleListing<M>>> candidates;
  private final LongSupplier nanos;
  private final Map<UUID, Long> failed = new ConcurrentHashMap<>();
  private volatile @Nullable UUID last;

  /**
   * @param candidates the current matches, the best first
   * @param nanos a monotonic clock, in nanoseconds
   */
  FailoverHandler(
      ModuleQuery<M> query, Supplier<List<ModuleListing<M>>> candidates, LongSupplier nanos) {
    this.query = query;
    this.candidates = candidates;
    this.nanos = nanos;
  }

  @Override
  public @Nullable Object invoke(Object proxy, Method method, Object @Nullable [] args)
      throws Throwable {
    if (method.getDeclaringClass() == Object.class) {
      return switch (method.getName()) {
        case "equals" -> args != null && proxy == args[0];
        case "hashCode" -> System.identityHashCode(proxy);
        default -> "any " + query;
      };
    }
    Optional<ModuleListing<M>> first = choose(null);
    if (first.isEmpty()) {
      throw nothing(method);
    }
    try {
      return call(first.get(), method, args);
    } catch (RemoteException | NotReadyException e) {
      if (!method.isAnnotationPresent(Idempotent.class)) {
        throw e instanceof RemoteException failure
            ? new CallFailedException(
                method.getName() + " on " + first.get().path(), mayHaveRun(failure), failure)
            : e;
      }
      Optional<ModuleListing<M>> other = choose(first.get().id());
      if (other.isEmpty() || Thread.currentThread().isInterrupted()) {
        throw e;
      }
      try {
        return call(other.get(), method, args);
      } catch (RemoteException | NotReadyException again) {
        again.addSuppressed(e);
        throw again;
      }
    }
  }

  private @Nullable Object call(ModuleListing<M> target, Method method, Object @Nullable [] args)
      throws Throwable {
    try {
      method.setAccessible(true); // the interface may be package-private
      @Nullable Object answer = method.invoke(target.module(), args);
      last = target.id();
      return answer;
    } catch (InvocationTargetException e) {
      Throwable cause = Objects.requireNonNull(e.getCause());
      if (cause instanceof RemoteException || cause instanceof NotReadyException) {
        failed.put(target.id(), nanos.getAsLong());
      }
      throw cause;
    }
  }

  private Optional<ModuleListing<M>> choose(@Nullable UUID not) {
    List<ModuleListing<M>> all = candidates.get();
    long now = nanos.getAsLong();
    failed.values().removeIf(when -> now - when > AVOID_NANOS);
    @Nullable UUID favourite = last;
    return all.stream()
        .filter(each -> !each.id().equals(not))
        .min( // the first of equals, which is the best
            Comparator.comparing((ModuleListing<M> each) -> failed.containsKey(each.id()))
                .thenComparing(each -> CachedModuleDirectory.isFailedOrStopped(each))
                .thenComparing(each -> !each.id().equals(favourite)));
  }

  private Exception nothing(Method method) {
    NoModuleFoundException nothing = new NoModuleFoundException(query);
    boolean declared =
        Arrays.stream(method.getExceptionTypes())
            .anyMatch(type -> type.isAssignableFrom(NoModuleFoundException.class));
    return declared ? nothing : new IllegalStateException(nothing.getMessage(), nothing);
  }

  private static boolean mayHaveRun(RemoteException failure) {
    if (failure instanceof ExecutionCertainty known) {
      return known.mayHaveRun();
    }
    return !(failure instanceof ConnectException
        || failure instanceof ConnectIOException
        || failure instanceof UnknownHostException
        || failure instanceof NoSuchObjectException
        // By name, not by type: this layer does not depend on activation.
        || failure.getClass().getSimpleName().equals("ActivateFailedException"));
  }
}
