package org.dfra.core.config;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.util.Locale;
import org.jdom2.Element;
import org.jdom2.JDOMException;
import org.jdom2.Namespace;
import org.jdom2.input.JDOMParseException;
import org.jdom2.input.SAXBuilder;
import org.jdom2.input.sax.XMLReaders;
import org.jdom2.located.LocatedJDOMFactory;

/** Parses a text as XML with a given root element. */
final class XmlDocument {

  private static final String NO_DOCTYPE = "http://apache.org/xml/features/disallow-doctype-decl";

  /** The JDK's parser counts open elements; without a limit, deep nesting costs quadratic time. */
  private static final String MAX_DEPTH =
      "http://www.oracle.com/xml/jaxp/properties/maxElementDepth";

  /** DFRA's documents nest elements at most 8 deep. */
  private static final int DEPTH = 64;

  private static final int MAX_BYTES = 16 << 20;

  private XmlDocument() {}

  /**
   * The root element; it and all its descendants have line numbers.
   *
   * @throws ConfigurationException if the text is not well-formed, is larger than 16 MiB or nested
   *     deeper than 64 elements, or it has another root
   */
  static Element parseRoot(
      byte[] text, SourceLocation whole, XmlSchema schema, ConfigurationFaults faults) {
    if (text.length > MAX_BYTES) {
      throw new ConfigurationException(
          whole + ": the file has " + text.length + " bytes, at most " + MAX_BYTES + " are read");
    }
    SAXBuilder builder = new SAXBuilder(XMLReaders.NONVALIDATING, null, new LocatedJDOMFactory());
    builder.setXMLFilter(schema.renamedAttributes(whole, faults));
    // Without a document type there are no entities, so nothing outside the text is read.
    builder.setFeature(NO_DOCTYPE, true);
    builder.setExpandEntities(false);
    builder.setProperty(XmlSchema.LOCALE, Locale.ROOT);
    builder.setProperty(MAX_DEPTH, DEPTH);
    try {
      Element root = builder.build(new ByteArrayInputStream(text)).getRootElement();
      requireRoot(root, whole, schema);
      return root;
    } catch (JDOMParseException e) {
      SourceLocation place = new SourceLocation(whole.file(), Math.max(0, e.getLineNumber()));
      throw new ConfigurationException(place + ": " + sentence(e), e);
    } catch (JDOMException | IOException e) {
      throw new ConfigurationException(
          whole + ": the XML cannot be read (" + e.getMessage() + "); correct it", e);
    }
  }

  private static void requireRoot(Element root, SourceLocation whole, XmlSchema schema) {
    Namespace namespace = schema.namespace();
    if (root.getName().equals(schema.root()) && root.getNamespace().equals(namespace)) {
      return;
    }
    String written =
        root.getNamespaceURI().isEmpty()
            ? "in no namespace"
            : "in the namespace " + root.getNamespaceURI();
    throw new ConfigurationException(
        XmlValues.place(whole.file(), root)
            + ": the root element is <"
            + root.getName()
            + "> "
            + written
            + "; write <"
            + schema.root()
            + " xmlns=\""
            + namespace.getURI()
            + "\" …>");
  }

  private static String sentence(JDOMParseException fault) {
    Throwable cause = fault.getCause() == null ? fault : fault.getCause();
    String message = String.valueOf(cause.getMessage());
    if (message.startsWith("JAXP00010006")) { // the JDK's message code for MAX_DEPTH
      return "elements are nested deeper than " + DEPTH + "; no robot needs that, correct it";
    }
    return message.contains(NO_DOCTYPE)
        ? "a document type is not allowed, since it could name files elsewhere; delete <!DOCTYPE …>"
        : "the XML is not well-formed ("
            + message.replaceFirst("\\.$", "")
            + "); correct it here or just above";
  }
}
