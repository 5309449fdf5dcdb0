package org.dfra.core.config;

import java.util.HashMap;
import java.util.Map;
import org.jdom2.Element;
import org.jdom2.located.Located;
import org.jspecify.annotations.Nullable;

/** Reads values of XML elements: substituted, checked, each with its place. */
public final class XmlValues {

  private final String file;
  private final Substitution substitution;
  private final ConfigurationFaults faults;

  /**
   * @param file the elements' file, as named to the reader
   */
  public XmlValues(String file, Substitution substitution, ConfigurationFaults faults) {
    this.file = file;
    this.substitution = substitution;
    this.faults = faults;
  }

  /** The end of an element's start tag, which is all that the parser reports. */
  static SourceLocation place(String file, Element element) {
    return new SourceLocation(file, element instanceof Located located ? located.getLine() : 0);
  }

  /** The end of an element's start tag. */
  public SourceLocation place(Element element) {
    return place(file, element);
  }

  /** Records a fault, unless it is null. */
  public void check(Element element, @Nullable String fault) {
    if (fault != null) {
      faults.add(place(element), fault);
    }
  }

  /** The value of an attribute; null if it is absent or its variables cannot be substituted. */
  public @Nullable String attribute(Element element, String name) {
    String written = element.getAttributeValue(name);
    return written == null ? null : substitution.apply(written, place(element));
  }

  /** The value of an attribute, or a default if it is absent. */
  public @Nullable String attribute(Element element, String name, String absent) {
    return element.getAttributeValue(name) == null ? absent : attribute(element, name);
  }

  /** The text between an element's tags, trimmed. */
  public @Nullable String text(Element element) {
    return substitution.apply(element.getTextTrim(), place(element));
  }

  /** The attribute {@code name} in lower_snake_case. */
  public @Nullable String name(Element element) {
    String name = attribute(element, "name");
    check(element, name == null ? null : DescriptionRules.name(element.getName(), name));
    return name;
  }

  /** The attribute {@code restart}; absent is true. */
  boolean restart(Element element) {
    String restart = attribute(element, "restart", "true");
    if (restart != null && !restart.equals("true") && !restart.equals("false")) {
      check(element, "restart is \"" + restart + "\"; write true or false");
    }
    return !"false".equals(restart);
  }

  /** A set of names of one kind, each of which may occur once. */
  public UniqueNames uniqueNames() {
    return new UniqueNames();
  }

  /** Records the first place of each name. */
  public final class UniqueNames {
    private final Map<String, SourceLocation> first = new HashMap<>();

    private UniqueNames() {}

    /**
     * @param what the named object, with its name, for the error message about a duplicate
     */
    public void requireFirst(Element element, String name, String what, String remedy) {
      SourceLocation earlier = first.putIfAbsent(name, place(element));
      if (earlier != null) {
        faults.add(
            place(element),
            "there is a second "
                + what
                + ", the first is in line "
                + earlier.line()
                + "; "
                + remedy);
      }
    }
  }
}
