package org.dfra.security;

/**
 * A guard around another one, which answers all questions but those about calls: a subclass decides
 * about them, and overrides what else it changes.
 */
public abstract class ForwardingGuard implements Guard {

  /** The guard that is asked. */
  protected abstract Guard guard();

  @Override
  public Measurement measurement() {
    return guard().measurement();
  }

  @Override
  public void ended(AccessRequest request, CallUse use) {
    guard().ended(request, use);
  }

  @Override
  public Visibility visibility(Caller caller) {
    return guard().visibility(caller);
  }

  @Override
  public Permissions permissions() {
    return guard().permissions();
  }
}
