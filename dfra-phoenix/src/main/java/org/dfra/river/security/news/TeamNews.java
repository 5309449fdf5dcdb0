package org.dfra.river.security.news;

import java.io.IOException;
import java.io.Serializable;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.util.List;
import org.dfra.module.Idempotent;

/**
 * What the authority of a team has published, as far as a process knows; and the ends of audit
 * trails.
 */
public interface TeamNews extends Remote {

  /**
   * Which ones a process has.
   *
   * @param revocations number of the list of revoked certificates; 0 for none
   * @param policy version of the policy; 0 for the one that comes with DFRA
   */
  record Numbers(long revocations, long policy) implements Serializable {}

  /**
   * A policy as its authority has published it.
   *
   * @param text of the XML
   * @param signature of the text
   */
  record SignedPolicy(byte[] text, byte[] signature) implements Serializable {}

  /**
   * The signed end of an audit trail.
   *
   * @param stream of the trail
   * @param number of its last line
   * @param hash of that line, in hexadecimal digits
   * @param timeMillis when it was signed, since 1970, UTC
   * @param signature in Base64
   */
  record SignedHead(String stream, long number, String hash, long timeMillis, String signature)
      implements Serializable {}

  /**
   * The signed ends of all audit trails of one member.
   *
   * @param certificate of the member, in DER
   * @param heads at most 64
   */
  record SignedHeads(byte[] certificate, List<SignedHead> heads) implements Serializable {}

  /** Which ones it has. */
  @Idempotent
  Numbers numbers() throws RemoteException;

  /**
   * The list of revoked certificates, in DER or PEM.
   *
   * @throws IOException if it has none, or cannot read it
   */
  @Idempotent
  byte[] revocations() throws IOException;

  /**
   * The policy.
   *
   * @throws IOException if it has none, or cannot read it
   */
  @Idempotent
  SignedPolicy policy() throws IOException;

  /**
   * Gives it a list of revoked certificates. One that is not newer than its own changes nothing.
   *
   * @throws IOException if the authority has not signed the list, or it cannot be stored
   */
  @Idempotent
  void takeRevocations(byte[] list) throws IOException;

  /**
   * Gives it a policy. One that is not newer than its own changes nothing.
   *
   * @throws IOException if the authority has not signed the policy, it has faults, or it cannot be
   *     stored
   */
  @Idempotent
  void takePolicy(SignedPolicy policy) throws IOException;

  /**
   * Gives it the ends of the caller's audit trails, which it keeps, and returns those of its own.
   *
   * @throws IOException if they are not signed by a member of the team, are too many, or cannot be
   *     stored
   */
  @Idempotent
  SignedHeads exchangeHeads(SignedHeads own) throws IOException;

  /**
   * The ends of a member's audit trails that it keeps, as the lines of a file of heads.
   *
   * @param member such as {@code robot atrv1 of field}
   * @throws IOException if it cannot read them
   */
  @Idempotent
  byte[] keptHeads(String member) throws IOException;
}
