package org.dfra.core.audit;

import java.security.cert.X509Certificate;
import org.dfra.security.Member;

/**
 * A head with the certificate of its signer.
 *
 * @param member whose trail it is: whom the certificate names
 */
public record KeptHead(Member member, AuditHead head, X509Certificate certificate) {

  /**
   * A head and who signed it.
   *
   * @throws IllegalArgumentException if the certificate names no member
   */
  public static KeptHead of(AuditHead head, X509Certificate certificate) {
    return new KeptHead(Member.of(certificate.getSubjectX500Principal()), head, certificate);
  }

  /** Whether the certificate's key has signed the head. */
  public boolean isSigned() {
    return head.verify(certificate);
  }
}
