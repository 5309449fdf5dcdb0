package org.dfra.river.filter;

/**
 * Marks a class loader whose classes were admitted by trust: who may run code here may also send
 * data of that code's classes.
 */
public interface TrustedLoader {}
