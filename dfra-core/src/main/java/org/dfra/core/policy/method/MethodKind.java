package org.dfra.core.policy.method;

import java.util.Arrays;
import java.util.Locale;
import java.util.stream.Collectors;

/**
 * What a remote method does, as far as it matters for who may call it. If the interfaces of an
 * object disagree about one of its methods, the kind that is declared last here counts.
 */
public enum MethodKind {
  /** Reads a state, and changes nothing. */
  READ("reads a state"),
  /** Registers a listener for events. */
  LISTEN("registers a listener"),
  /** Acquires, renews or cancels a lease that gives no right to command. */
  LEASE("acquires, renews or cancels a lease"),
  /** Delivers an event or a message to a listener or an agent. */
  DELIVER("delivers an event or a message"),
  /** Starts a module whose process does not run. */
  ACTIVATE("starts a module that does not run"),
  /** Makes an emergency stop. */
  STOP("makes an emergency stop"),
  /** Makes a robot act, or acquires the right to command it. */
  COMMAND("makes a robot act"),
  /** Registers a service with a lookup service, or changes its attributes. */
  REGISTER("registers a service"),
  /** Releases an emergency stop. */
  RELEASE("releases an emergency stop"),
  /** Changes a module or a service for all its clients. */
  ADMINISTER("changes a module for all its clients");

  private final String meaning;

  MethodKind(String meaning) {
    this.meaning = meaning;
  }

  /** The kind in policies, such as {@code read}. */
  public String text() {
    return name().toLowerCase(Locale.ROOT);
  }

  /** What methods of this kind do, after "it". */
  public String meaning() {
    return meaning;
  }

  /**
   * Parses {@link #text()}.
   *
   * @throws IllegalArgumentException if it is no kind; the message names those that exist
   */
  public static MethodKind of(String text) {
    return Arrays.stream(values())
        .filter(each -> each.text().equals(text))
        .findFirst()
        .orElseThrow(
            () ->
                new IllegalArgumentException(
                    "kind \""
                        + text
                        + "\" is none of "
                        + Arrays.stream(values())
                            .map(MethodKind::text)
                            .collect(Collectors.joining(", "))));
  }
}
