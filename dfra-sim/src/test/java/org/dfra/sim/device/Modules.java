package org.dfra.sim.device;

import java.time.Duration;
import java.util.List;
import java.util.regex.Pattern;
import org.awaitility.Awaitility;
import org.awaitility.core.ConditionFactory;
import org.dfra.core.lease.LeaseTerms;
import org.dfra.core.module.DeviceImpl;
import org.dfra.core.module.ModuleImpl;
import org.dfra.lifecycle.Incident;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Diagnosis;
import org.dfra.module.NotReadyException;
import org.dfra.module.Parameter;

/** What tests of drivers with their emulated devices do with a module, whatever it is. */
public final class Modules {

  /**
   * Leases that a test on an overloaded machine does not outlive, also by a clock that runs many
   * times as fast.
   */
  public static final LeaseTerms LONG_LEASES =
      new LeaseTerms(Duration.ofHours(1), Duration.ofMinutes(10));

  /** An overloaded machine may take its time; what does not come at all takes this long to fail. */
  private static final Duration PATIENCE = Duration.ofSeconds(60);

  /** As in {@code no scan for 2.2 s}. */
  private static final Pattern SILENCE = Pattern.compile("\\bno .+ for [0-9.]+ s\\b");

  private Modules() {}

  /**
   * Waits patiently for whatever another thread does. A module that has nothing to serve just now
   * is asked again: on an overloaded machine a reading may grow too old before it is looked at.
   */
  public static ConditionFactory await() {
    return patient(Awaitility.await());
  }

  /** The same, with a name for what is awaited, or the seed. */
  public static ConditionFactory await(String alias) {
    return patient(Awaitility.await(alias));
  }

  private static ConditionFactory patient(ConditionFactory factory) {
    return factory
        .atMost(PATIENCE)
        .pollInterval(Duration.ofMillis(5))
        .ignoreExceptionsInstanceOf(NotReadyException.class);
  }

  public static void awaitReadiness(ModuleImpl module, Readiness expected) {
    await(module + ", " + expected).until(module::readiness, expected::equals);
  }

  /**
   * Waits until each test of a module whose cable is pulled says so. A link over TCP may be open
   * for a moment, before its emulator hangs up again.
   */
  public static void awaitNoLink(DeviceImpl module) {
    module.tests().forEach(test -> awaitNoLink(module, test));
  }

  /** The same, for one of its tests. */
  public static void awaitNoLink(DeviceImpl module, String test) {
    await(test)
        .until(
            () -> module.test(test).finding(), text -> text.startsWith("the link is not open: "));
  }

  /**
   * Waits until a test of a module passes: where the computer stands still for a moment, a device
   * is silent by a fast clock.
   */
  public static Diagnosis awaitPassed(DeviceImpl module, String test) {
    return await(test).until(() -> module.test(test), Diagnosis::passed);
  }

  /** The same, for each of its tests. */
  public static void awaitPassed(DeviceImpl module) {
    module.tests().forEach(test -> awaitPassed(module, test));
  }

  /** Waits until a recovery of a module is done, for the same reason. */
  public static Diagnosis awaitRecovered(DeviceImpl module, String recovery) {
    return await(recovery).until(() -> module.recover(recovery), Diagnosis::passed);
  }

  /**
   * The failures of a module that are not of a device that was silent, as each is by a fast clock
   * where the computer stands still.
   */
  public static List<String> failuresButSilence(ModuleImpl module) {
    return module.history().recent().stream()
        .filter(each -> each.kind() == Incident.Kind.FAILURE)
        .map(Incident::description)
        .filter(what -> !SILENCE.matcher(what).find())
        .toList();
  }

  /** What a parameter is now. */
  public static String parameter(ModuleImpl module, String name) {
    return module.parameters().stream()
        .filter(parameter -> parameter.name().equals(name))
        .map(Parameter::value)
        .findFirst()
        .orElseThrow();
  }

  /** The same, where it is a whole number. */
  public static long number(ModuleImpl module, String name) {
    return Long.parseLong(parameter(module, name));
  }
}
