package org.dfra.cli.security;

import java.io.ByteArrayInputStream;
import java.util.Optional;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;

/** The number of a policy: the attribute {@code number} or {@code version} of its root element. */
final class PolicyVersion {

  private PolicyVersion() {}

  /** Empty if it has none, or is no XML. */
  static Optional<String> of(byte[] policy) {
    XMLInputFactory factory = XMLInputFactory.newFactory();
    factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
    factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
    try {
      XMLStreamReader reader = factory.createXMLStreamReader(new ByteArrayInputStream(policy));
      while (reader.hasNext()) {
        if (reader.next() == XMLStreamConstants.START_ELEMENT) {
          return Optional.ofNullable(reader.getAttributeValue(null, "number"))
              .or(() -> Optional.ofNullable(reader.getAttributeValue(null, "version")));
        }
      }
      return Optional.empty();
    } catch (XMLStreamException e) {
      return Optional.empty(); // the policy's own reader reports what is wrong with it
    }
  }
}
