package org.dfra.module;

import java.lang.annotation.Documented;
import java.lang.annotation.ElementType;
import java.lang.annotation.Retention;
import java.lang.annotation.RetentionPolicy;
import java.lang.annotation.Target;

/**
 * A method that may run twice without harm: a query, not a command.
 *
 * <p>When the connection breaks during such a call, the call is repeated once. A method without
 * this annotation is never repeated, since it may have been executed.
 */
@Documented
@Retention(RetentionPolicy.RUNTIME)
@Target(ElementType.METHOD)
public @interface Idempotent {}
