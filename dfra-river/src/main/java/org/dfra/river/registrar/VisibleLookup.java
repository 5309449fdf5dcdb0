package org.dfra.river.registrar;

import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import net.jini.core.entry.Entry;
import net.jini.core.lookup.ServiceID;
import org.dfra.security.Visibility;
import org.jspecify.annotations.Nullable;

/**
 * Answers the calls that read a lookup service, for callers from whom something may be hidden. It
 * answers as reggie does, but from {@link VisibleItems}: what is hidden has no influence on an
 * answer, neither on what a template matches nor on a count. Thread-safe.
 */
final class VisibleLookup {

  private final ReggieState state;
  private final ReggieMatcher matcher;
  private final ReggieItems items;
  private final VisibleItems visible;

  VisibleLookup(ReggieState state, ReggieMatcher matcher, ReggieItems items, VisibleItems visible) {
    this.state = state;
    this.matcher = matcher;
    this.items = items;
    this.visible = visible;
  }

  /** Whether it answers a method of reggie's remote interface. */
  static boolean answers(String method) {
    return switch (method) {
      case "lookup", "getEntryClasses", "getFieldValues", "getServiceTypes" -> true;
      default -> false;
    };
  }

  /**
   * Answers a call.
   *
   * @param args which were checked
   * @throws RuntimeException for arguments for which reggie throws one
   */
  @Nullable Object answer(String method, @Nullable Object[] args, Visibility visibility) {
    Object template = Objects.requireNonNull(args[0]);
    List<Object> found = matching(template, visibility);
    return switch (method) {
      case "lookup" -> args.length == 1 ? first(found) : matches(found, number(args[1]));
      case "getEntryClasses" -> entryClasses(found, template);
      case "getFieldValues" ->
          fieldValues(found, matcher.entry(template, number(args[1])), number(args[2]));
      case "getServiceTypes" -> serviceTypes(found, template, (String) args[1]);
      default -> throw new IllegalArgumentException(method + " reads nothing");
    };
  }

  private static int number(@Nullable Object argument) {
    return (int) Objects.requireNonNull(argument);
  }

  /**
   * One service as a caller sees it, if it matches.
   *
   * @return a copy in reggie's form for storage; null if it does not match or is not listed
   */
  @Nullable Object matching(ServiceID service, Object template, Visibility visibility) {
    return state.select(service, item -> matching(item, template, visibility));
  }

  /** All services as a caller sees them, of those that match; copies. */
  List<Object> matching(Object template, Visibility visibility) {
    return state.select(item -> matching(item, template, visibility));
  }

  private @Nullable Object matching(Object item, Object template, Visibility visibility) {
    @Nullable Object seen = visible.seen(item, visibility);
    return seen != null && matcher.matches(template, seen) ? items.copy(seen) : null;
  }

  /** Entries as a caller sees them, of the lookup service itself. */
  Entry[] ownEntries(Entry[] all, Object itself, Visibility visibility) {
    List<Object> marshalled = List.of(items.marshalled(all));
    @Nullable Object seen = visible.seen(items.copy(itself, marshalled), visibility);
    return seen == null ? new Entry[0] : items.unmarshalled(List.of(items.entries(seen)));
  }

  private @Nullable Object first(List<Object> found) {
    return found.isEmpty() ? null : items.service(found.get(0));
  }

  private Object matches(List<Object> found, int most) {
    if (most < 0) {
      throw new IllegalArgumentException("negative maxMatches");
    }
    List<Object> sent =
        found.subList(0, Math.min(most, found.size())).stream().map(items::sent).toList();
    return items.matches(sent, found.size());
  }

  private @Nullable Object entryClasses(List<Object> found, Object template) {
    List<Object> classes = new ArrayList<>();
    List<@Nullable Object> codebases = new ArrayList<>();
    for (Object item : found) {
      for (Object each : items.entries(item)) {
        Object described = items.entryClass(each);
        if (!classes.contains(described) && matcher.isFurther(template, each)) {
          classes.add(described);
          codebases.add(items.codebase(each));
        }
      }
    }
    return items.entryClasses(classes, codebases);
  }

  private @Nullable Object fieldValues(List<Object> found, Object wanted, int field) {
    List<@Nullable Object> values = new ArrayList<>();
    for (Object item : found) {
      for (Object each : items.entries(item)) {
        if (matcher.matchesEntry(wanted, each)) {
          @Nullable Object value = items.fields(each)[field];
          if (!values.contains(value)) {
            values.add(value);
          }
        }
      }
    }
    return values.isEmpty() ? null : values.toArray();
  }

  private @Nullable Object serviceTypes(
      List<Object> found, Object template, @Nullable String prefix) {
    List<Object> types = new ArrayList<>();
    List<@Nullable Object> codebases = new ArrayList<>();
    found.forEach(each -> matcher.addTypes(types, codebases, template, prefix, each));
    return items.serviceTypes(types, codebases);
  }
}
