package org.dfra.river.security.news;

import java.io.IOException;
import java.io.Serializable;
import java.rmi.Remote;
import java.rmi.RemoteException;
import org.dfra.module.Idempotent;

/** What the authority of a team has published, as far as a process knows. */
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
}
