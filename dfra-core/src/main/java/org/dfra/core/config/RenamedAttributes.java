package org.dfra.core.config;

import org.jspecify.annotations.Nullable;
import org.xml.sax.Attributes;
import org.xml.sax.Locator;
import org.xml.sax.SAXException;
import org.xml.sax.helpers.AttributesImpl;
import org.xml.sax.helpers.XMLFilterImpl;

/**
 * Replaces old names of attributes while an XML document is parsed, so that neither its schema nor
 * its readers know them. An element with the old and the new name is a fault.
 */
final class RenamedAttributes extends XMLFilterImpl {

  private final String namespace;
  private final SourceLocation whole;
  private final ConfigurationFaults faults;
  private @Nullable Locator locator;

  /**
   * @param namespace the namespace of the elements whose attributes are translated
   * @param whole the file
   */
  RenamedAttributes(String namespace, SourceLocation whole, ConfigurationFaults faults) {
    this.namespace = namespace;
    this.whole = whole;
    this.faults = faults;
  }

  @Override
  public void setDocumentLocator(Locator locator) {
    this.locator = locator;
    super.setDocumentLocator(locator);
  }

  @Override
  public void startElement(String uri, String localName, String name, Attributes attributes)
      throws SAXException {
    super.startElement(
        uri, localName, name, uri.equals(namespace) ? renamed(localName, attributes) : attributes);
  }

  private Attributes renamed(String element, Attributes written) {
    AttributesImpl renamed = new AttributesImpl(written);
    String scope = RenamedNames.attributesOf(element);
    for (int i = renamed.getLength() - 1; i >= 0; i--) {
      String old = renamed.getLocalName(i);
      String now = RenamedNames.resolve(scope, place(), "the attribute", old);
      if (!now.equals(old)) {
        if (written.getIndex("", now) < 0) {
          renamed.setLocalName(i, now);
          renamed.setQName(i, now);
        } else {
          faults.add(
              place(),
              "<" + element + "> has " + now + " and its old name " + old + "; delete " + old);
          renamed.removeAttribute(i);
        }
      }
    }
    return renamed;
  }

  private SourceLocation place() {
    return new SourceLocation(
        whole.file(), locator == null ? 0 : Math.max(0, locator.getLineNumber()));
  }
}
