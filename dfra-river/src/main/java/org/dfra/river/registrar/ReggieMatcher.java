package org.dfra.river.registrar;

import java.lang.reflect.Field;
import java.lang.reflect.Method;
import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Reggie's own comparison of templates with items. Reggie 2.2.2 has no interface for it, so its
 * private methods are called: what a template means is then the same for callers from whom a part
 * is hidden. Thread-safe.
 */
final class ReggieMatcher {

  private final Method matchItem;
  private final Method matchEntry;
  private final Method attrMatch;
  private final Method addTypes;
  private final Field templateEntries;
  private final Field templateTypes;
  private final Field serviceType;
  private final Field codebase;

  /**
   * @param registrar reggie's class
   * @throws ReflectiveOperationException if that is not of reggie 2.2.2
   */
  ReggieMatcher(Class<?> registrar) throws ReflectiveOperationException {
    @Nullable ClassLoader loader = registrar.getClassLoader();
    Class<?> template = Class.forName("com.sun.jini.reggie.Template", false, loader);
    Class<?> item = Class.forName("com.sun.jini.reggie.Item", false, loader);
    Class<?> entry = Class.forName("com.sun.jini.reggie.EntryRep", false, loader);
    Class<?> type = Class.forName("com.sun.jini.reggie.ServiceType", false, loader);
    matchItem = ReggieFields.method(registrar, "matchItem", template, item);
    matchEntry = ReggieFields.method(registrar, "matchEntry", entry, entry);
    attrMatch = ReggieFields.method(registrar, "attrMatch", entry.arrayType(), entry);
    addTypes =
        ReggieFields.method(
            registrar,
            "addTypes",
            ArrayList.class,
            ArrayList.class,
            type.arrayType(),
            String.class,
            type,
            String.class);
    templateEntries = ReggieFields.accessible(template, "attributeSetTemplates");
    templateTypes = ReggieFields.accessible(template, "serviceTypes");
    serviceType = ReggieFields.accessible(item, "serviceType");
    codebase = ReggieFields.accessible(item, "codebase");
  }

  /** Whether an item matches a template. */
  boolean matches(Object template, Object item) {
    return Boolean.TRUE.equals(ReggieFields.call(matchItem, null, template, item));
  }

  /** Whether an entry matches one of a template. */
  boolean matchesEntry(Object wanted, Object entry) {
    return Boolean.TRUE.equals(ReggieFields.call(matchEntry, null, wanted, entry));
  }

  /** Whether the class of a matching item's entry is not known from the template already. */
  boolean isFurther(Object template, Object entry) {
    @Nullable Object wanted = ReggieFields.value(templateEntries, template);
    return Boolean.TRUE.equals(ReggieFields.call(attrMatch, null, wanted, entry));
  }

  /**
   * Adds the most specific types of an item that do not begin with a prefix.
   *
   * @param types array lists of those that were found before, and of their codebases
   */
  void addTypes(
      List<Object> types,
      List<@Nullable Object> codebases,
      Object template,
      @Nullable String prefix,
      Object item) {
    @Nullable Object unused =
        ReggieFields.call(
            addTypes,
            null,
            types,
            codebases,
            ReggieFields.value(templateTypes, template),
            prefix,
            ReggieFields.value(serviceType, item),
            ReggieFields.value(codebase, item));
  }

  /**
   * An entry of a template.
   *
   * @throws IndexOutOfBoundsException if it has no such entry
   */
  Object entry(Object template, int index) {
    @Nullable Object[] entries = (@Nullable Object[]) ReggieFields.value(templateEntries, template);
    if (entries == null || index < 0 || index >= entries.length || entries[index] == null) {
      throw new IndexOutOfBoundsException("the template has no entry " + index);
    }
    return entries[index];
  }
}
